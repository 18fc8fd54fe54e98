#include "time/catalogue.hpp"

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "parameters/one_of.hpp"
#include "parameters/range_validator.hpp"
#include "time/custom_table.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

void add_beta_gamma(List& list) {
  list.set("Beta", 0.25, "Newmark's parameter beta [-].", greater_than(0));
  list.set("Gamma", 0.5, "Newmark's parameter gamma [-]. 1/2 gives second order and no numerical damping.",
           at_least(0.5));
}

void add_points(List& list, const char* name, int value, const char* documentation, int least = 1) {
  list.set(name, value, documentation, between(least, 64));
}

Scheme newmark_scheme() {
  Scheme s{"Newmark",
           "2 (1 where Gamma > 1/2)",
           "linear: unconditional for 2 Beta >= Gamma; nonlinear: energy may grow",
           "linear momentum; energy of linear problems for Beta = 1/4, Gamma = 1/2",
           "one nonlinear solve per step; the other costs are relative to it",
           "Newmark 1959",
           {},
           [](const List& p) { return newmark(p.get<double>("Beta"), p.get<double>("Gamma")); }};
  add_beta_gamma(s.parameters);
  return s;
}

Scheme bathe_scheme() {
  Scheme s{"Bathe Composite",
           "2",
           "linear: unconditional, with the given spectral radius at infinite frequency; dissipates energy",
           "linear momentum",
           "two nonlinear solves per step; the same error allows longer steps",
           "Bathe 2007; Noh and Bathe 2019",
           {},
           [](const List& p) {
             const double rho = p.get<double>("Spectral Radius");
             const double split = p.get<double>("Split");
             return bathe_composite(rho, split == 0 ? bathe_default_split(rho) : split);
           }};
  s.parameters.set("Spectral Radius", 0.0,
                   "Spectral radius at infinite frequency [-]. 0 with Split 0.5 is the scheme of Bathe 2007.",
                   between(0, 1));
  s.parameters.set("Split", 0.5,
                   "End of the first stage as a fraction of the step [-]. 0 chooses the value that gives both stages "
                   "the same tangent.",
                   at_least_and_less_than(0, 1));
  return s;
}

Scheme composite_scheme() {
  Scheme s{"Gautam-Sauer Composite",
           "2 (1 where Gamma is not 2 Beta)",
           "linear: unconditional for 2 Beta >= Gamma; the work of the interaction is exact up to time quadrature",
           "linear momentum; the work of the interaction on the linear path is exact up to time quadrature",
           "one nonlinear solve per step; the interaction at several time points adds little",
           "Gautam and Sauer 2014",
           {},
           [](const List& p) {
             const Path path = p.get<std::string>("Path") == "Linear" ? Path::Linear : Path::Kinematic;
             return gautam_sauer_composite(p.get<double>("Beta"), p.get<double>("Gamma"),
                                           p.get<int>("Interaction Points"), path);
           }};
  add_beta_gamma(s.parameters);
  add_points(
      s.parameters, "Interaction Points", 5,
      "Number of Gauss points in time for the interaction. 0: the exact mean over the linear path, in closed form.", 0);
  s.parameters.set("Path", "Linear",
                   "Path of the displacement within a step. Kinematic is quadratic and consistent with Newmark; it may "
                   "cross the wall.",
                   one_of({"Linear", "Kinematic"}));
  return s;
}

Scheme average_vector_field_scheme() {
  Scheme s{"Average Vector Field",
           "2",
           "nonlinear: the conserved energy bounds the motion",
           "linear momentum; energy up to time quadrature",
           "one nonlinear solve per step; elastic forces at several time points",
           "Quispel and McLaren 2008",
           {},
           [](const List& p) {
             return average_vector_field(p.get<int>("Elastic Points"), p.get<int>("Interaction Points"));
           }};
  add_points(s.parameters, "Elastic Points", 4, "Number of Gauss points in time for the elastic force.");
  add_points(
      s.parameters, "Interaction Points", 8,
      "Number of Gauss points in time for the interaction. 0: the exact mean over the linear path, in closed form.", 0);
  return s;
}

Scheme generalized_alpha_scheme() {
  Scheme s{"Generalized-Alpha",
           "2",
           "linear: unconditional, with the given spectral radius at infinite frequency",
           "linear momentum; energy of linear problems for Spectral Radius 1",
           "one nonlinear solve per step",
           "Chung and Hulbert 1993",
           {},
           [](const List& p) { return generalized_alpha(p.get<double>("Spectral Radius")); }};
  s.parameters.set("Spectral Radius", 0.5, "Spectral radius at infinite frequency [-].", between(0, 1));
  return s;
}

Scheme hht_scheme() {
  Scheme s{"HHT-Alpha",
           "2",
           "linear: unconditional; damps high frequencies",
           "linear momentum; energy of linear problems for Alpha = 0",
           "one nonlinear solve per step",
           "Hilber, Hughes and Taylor 1977",
           {},
           [](const List& p) { return hht_alpha(p.get<double>("Alpha")); }};
  s.parameters.set("Alpha", -0.05,
                   "Parameter alpha [-]. The more negative it is, the more the scheme damps high frequencies.",
                   between(-1.0 / 3, 0));
  return s;
}

Scheme midpoint_scheme() {
  Scheme s{"Midpoint",
           "2",
           "linear: unconditional; nonlinear: energy may grow",
           "linear and angular momentum; energy of linear problems",
           "one nonlinear solve per step",
           "Simo, Tarnow and Wong 1992",
           {},
           [](const List& p) { return midpoint(p.get<std::string>("Interaction Mean") == "Exact"); }};
  s.parameters.set("Interaction Mean", "Points",
                   "Evaluation of the interaction. Points takes the force at the middle of the step; Exact takes its "
                   "exact mean over the linear path, so that its work is exact.",
                   one_of({"Points", "Exact"}));
  return s;
}

Scheme energy_momentum_scheme() {
  return {"Energy-Momentum",
          "2",
          "nonlinear: the conserved energy bounds the motion",
          "energy, linear and angular momentum, up to the tolerance of Newton's method",
          "one nonlinear solve per step; its tangent is unsymmetric, which requires LU or GMRES",
          "Simo and Tarnow 1992; Gonzalez 2000; Gautam and Sauer 2013",
          {},
          [](const List&) { return energy_momentum(); }};
}

Scheme central_difference_scheme() {
  Scheme s{"Central Difference",
           "2",
           "conditional: longer steps are divided; stiffness and smallest gap give the stable step size",
           "linear and angular momentum; energy oscillates about its value",
           "no solve (lumped mass); many short steps with one force evaluation each",
           "Newmark 1959 with beta = 0; Belytschko, Liu, Moran and Elkhodary 2014",
           {},
           [](const List& p) { return central_difference(p.get<double>("Safety")); }};
  s.parameters.set("Safety", 0.4,
                   "Fraction of the stable step size that is used [-]. Near 1, steps into the steep repulsion of the "
                   "wall add energy.",
                   greater_than_and_at_most(0, 1));
  return s;
}

Scheme static_scheme() {
  return {"Static",
          "not applicable: each step is an equilibrium",
          "an unstable equilibrium leads to a jump to another one, or to a failed step",
          "nothing; the forces are in balance, without inertia and damping",
          "one nonlinear solve per step, no mass matrix",
          "Load stepping, e.g. Wriggers 2008",
          {},
          [](const List&) { return static_equilibrium(); }};
}

}  // namespace

const std::vector<Scheme>& schemes() {
  static const std::vector<Scheme> all{newmark_scheme(),
                                       bathe_scheme(),
                                       composite_scheme(),
                                       average_vector_field_scheme(),
                                       energy_momentum_scheme(),
                                       midpoint_scheme(),
                                       generalized_alpha_scheme(),
                                       hht_scheme(),
                                       central_difference_scheme(),
                                       static_scheme()};
  return all;
}

const Scheme& custom_scheme() {
  static const Scheme custom{
      "Custom",
      "given by the table",
      "given by the table",
      "what the table implies",
      "one nonlinear solve per stage",
      "A table of stages that the scene defines. It is rejected unless it reproduces u = 1, t and t^2.",
      custom_parameters(),
      [](const List& p) { return custom_table(p); }};
  return custom;
}

const char* default_scheme() { return "Gautam-Sauer Composite"; }

const Scheme& scheme(const std::string& name) {
  if (name == custom_scheme().name) return custom_scheme();
  std::vector<std::string> names;
  for (const Scheme& candidate : schemes()) {
    if (candidate.name == name) return candidate;
    names.push_back(candidate.name);
  }
  throw InputError(no_such("scheme", name, names, "There are"));
}

}  // namespace ixos
