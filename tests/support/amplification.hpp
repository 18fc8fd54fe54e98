/// Amplification matrices of the schemes for the undamped linear oscillator, from the formulas of the literature and by
/// none of the library's own code.
#pragma once
#include <Teuchos_SerialDenseMatrix.hpp>
#include <complex>
#include <vector>

namespace ixos::test {

/// x_n+1 = A x_n for u'' + omega^2 u = 0, x = (u, dt v, dt^2 a) or, where the scheme keeps no acceleration, (u, dt v).
/// All take omega dt.
using Amplification = Teuchos::SerialDenseMatrix<int, double>;

/// Newmark 1959; Hughes 1987, section 9.1.
Amplification newmark_amplification(double beta, double gamma, double omega_dt);

/// Noh and Bathe 2019; spectral radius 0 and split 1/2 is Bathe 2007.
Amplification bathe_amplification(double spectral_radius, double split, double omega_dt);
/// The split of equal tangents in both stages, for a spectral radius below 1.
double equal_tangents_split(double spectral_radius);

/// Gautam and Sauer 2014 without interaction: the elastic impulse by the trapezoid, v from Newmark with the
/// acceleration of the balance.
Amplification composite_amplification(double beta, double gamma, double omega_dt);

/// The trapezoid, also the midpoint rule, the average vector field and the discrete gradient of a quadratic energy.
Amplification trapezoid_amplification(double omega_dt);

/// Chung and Hulbert 1993, with their optimal beta and gamma.
Amplification generalized_alpha_amplification(double spectral_radius, double omega_dt);

/// Hilber, Hughes and Taylor 1977.
Amplification hht_amplification(double alpha, double omega_dt);

/// Central difference as velocity Verlet.
Amplification central_difference_amplification(double omega_dt);

/// With multiplicity.
std::vector<std::complex<double>> eigenvalues(const Amplification& amplification);

struct SpectralProperties {
  double spectral_radius;
  double period_error;  ///< T_numerical/T - 1 of the complex pair, its angle in (0, pi); NaN where all are real
  double decay;         ///< 1 - the factor of the amplitude in a numerical period; NaN likewise
};

SpectralProperties spectral_properties(const std::vector<std::complex<double>>& eigenvalues, double omega_dt);

}  // namespace ixos::test
