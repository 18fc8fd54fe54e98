/// The schemes, each a function from its parameters to its table. U_j, V_j, A_j below are u_j, dt v_j, dt^2 a_j.
#pragma once
#include "time/table.hpp"

namespace ixos {

/// Newmark (1959): balance at the end of the step. Order 2 for gamma = 1/2, else 1. Unconditionally stable for linear
/// problems if 2 beta >= gamma >= 1/2. Keeps linear momentum; energy of linear problems for beta = 1/4, gamma = 1/2.
/// Needs beta > 0.
Table newmark(double beta, double gamma);

/// Bathe's composite scheme with spectral radius (Noh and Bathe 2019; rho = 0, split = 1/2 is Bathe 2007): trapezoid to
/// t_n + split dt, then y = y_n + dt (q0 y'_n + q1 y'_g + q2 y') for u and v. Order 2, unconditionally stable for
/// linear problems, spectral radius rho at infinite frequency. Keeps linear momentum, loses energy. rho in [0, 1],
/// split in (0, 1).
Table bathe_composite(double spectral_radius, double split);

/// Returns the split for which both stages have the same tangent:
///   (2 - sqrt(2 + 2 rho))/(1 - rho) = 2/(2 + sqrt(2 + 2 rho)).
double bathe_default_split(double spectral_radius);

/// Gautam and Sauer (2014): the balance of momentum over the step, elastic forces by the trapezoid, interaction by n
/// Gauss points on a path (0: the exact mean on the linear path), v from Newmark. Order 2 for gamma = 2 beta. Keeps
/// linear momentum; on the linear path the work of the interaction is exact to time quadrature. Needs beta > 0.
Table gautam_sauer_composite(double beta, double gamma, int interaction_points, Path path);

/// Average vector field (Quispel and McLaren 2008): the mean force along the straight line from u_n to u, by Gauss
/// points (interaction: in closed form for 0 points). Order 2. Keeps linear momentum and, to time quadrature, energy of
/// any hyperelastic law and interaction; angular momentum only to second order.
Table average_vector_field(int elastic_points, int interaction_points);

/// Chung and Hulbert (1993): M [(1 - a_m) a + a_m a_n] + (1 - a_f) f + a_f f_n = f_ext weighted likewise, Newmark's
/// kinematics. Order 2, unconditionally stable for linear problems, spectral radius rho at infinite frequency (rho in
/// [0, 1]); rho = 1 keeps the energy of linear problems. Keeps linear momentum.
Table generalized_alpha(double spectral_radius);

/// Hilber, Hughes and Taylor (1977): generalized_alpha's equations with a_m = 0, a_f = -alpha, alpha in [-1/3, 0]; 0 is
/// the trapezoid.
Table hht_alpha(double alpha);

/// The implicit midpoint rule (Simo, Tarnow and Wong 1992), in momentum form: forces at (u_n + u)/2, the interaction
/// there too or by its exact mean. Order 2. Keeps linear and angular momentum; energy of linear problems.
Table midpoint(bool exact_interaction = false);

/// Energy-momentum (Simo and Tarnow 1992; Gonzalez 2000; contact: Gautam and Sauer 2013), in momentum form: the
/// discrete gradient of the stored energy and of the interaction. Order 2. Keeps energy, linear and angular momentum,
/// all to the tolerance of the solver. Its tangent is unsymmetric.
Table energy_momentum();

/// The central difference scheme (Newmark 1959 with beta = 0, gamma = 1/2; Belytschko, Liu, Moran and Elkhodary 2014)
/// as velocity Verlet: explicit, lumped mass, no equation to solve. Order 2 (damping acts on the velocity extrapolated
/// from the step's start). Stable for steps up to 2/(sqrt(w^2 + c^2) + c), of which a run uses the share `safety`: near
/// 1 a step up a stiffening wall gives energy. Keeps linear and angular momentum, and a nearby energy for as long as
/// the step is constant.
Table central_difference(double safety);

/// No inertia and no damping: equilibrium at the end of each step, time a parameter of the loads and motions.
Table static_equilibrium();

}  // namespace ixos
