#include "time/catalogue.hpp"

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "base/one_of.hpp"
#include "base/range_validator.hpp"
#include "time/custom_table.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

void add_beta_gamma(List& list) {
  list.set("Beta", 0.25, "Newmark's beta [-]", greater_than(0));
  list.set("Gamma", 0.5, "Newmark's gamma [-]; 1/2 is second order without numerical damping", at_least(0.5));
}

void add_points(List& list, const char* name, int value, const char* documentation, int least = 1) {
  list.set(name, value, documentation, between(least, 64));
}

Scheme newmark_scheme() {
  Scheme s{"Newmark",
           "2 (1 where Gamma > 1/2)",
           "linear: unconditional for 2 Beta >= Gamma; nonlinear: energy may grow",
           "linear momentum; energy of linear problems for Beta = 1/4, Gamma = 1/2",
           "one solve a step: the measure of the others",
           "Newmark 1959",
           {},
           [](const List& p) { return newmark(p.get<double>("Beta"), p.get<double>("Gamma")); }};
  add_beta_gamma(s.parameters);
  return s;
}

Scheme bathe_scheme() {
  Scheme s{"Bathe Composite",
           "2",
           "linear: unconditional, spectral radius as given at infinite frequency; loses energy",
           "linear momentum",
           "two solves a step, which may be longer for the same error",
           "Bathe 2007; Noh and Bathe 2019",
           {},
           [](const List& p) {
             const double rho = p.get<double>("Spectral Radius");
             const double split = p.get<double>("Split");
             return bathe_composite(rho, split == 0 ? bathe_default_split(rho) : split);
           }};
  s.parameters.set("Spectral Radius", 0.0, "spectral radius at infinite frequency [-]; 0 with Split 0.5 is Bathe 2007",
                   between(0, 1));
  s.parameters.set("Split", 0.5, "end of the first stage in steps [-]; 0 chooses equal tangents for both stages",
                   at_least_and_less_than(0, 1));
  return s;
}

Scheme composite_scheme() {
  Scheme s{"Gautam-Sauer Composite",
           "2 (1 where Gamma is not 2 Beta)",
           "linear: unconditional for 2 Beta >= Gamma; interaction work exact to time quadrature",
           "linear momentum; work of the interaction on the linear path",
           "one solve a step; the interaction at several times, which hardly shows",
           "Gautam and Sauer 2014",
           {},
           [](const List& p) {
             const Path path = p.get<std::string>("Path") == "Linear" ? Path::Linear : Path::Kinematic;
             return gautam_sauer_composite(p.get<double>("Beta"), p.get<double>("Gamma"),
                                           p.get<int>("Interaction Points"), path);
           }};
  add_beta_gamma(s.parameters);
  add_points(s.parameters, "Interaction Points", 5,
             "Gauss points in time for the interaction; 0: the exact mean, in closed form (linear path)", 0);
  s.parameters.set(
      "Path", "Linear",
      "path of the displacement within a step; \"Kinematic\" is quadratic and consistent with Newmark, and "
      "may cross the wall",
      one_of({"Linear", "Kinematic"}));
  return s;
}

Scheme average_vector_field_scheme() {
  Scheme s{"Average Vector Field",
           "2",
           "energy is bounded by its conservation",
           "linear momentum; energy to time quadrature",
           "one solve a step; elastic forces at several times",
           "Quispel and McLaren 2008",
           {},
           [](const List& p) {
             return average_vector_field(p.get<int>("Elastic Points"), p.get<int>("Interaction Points"));
           }};
  add_points(s.parameters, "Elastic Points", 4, "Gauss points in time for the elastic force");
  add_points(s.parameters, "Interaction Points", 8,
             "Gauss points in time for the interaction; 0: the exact mean, in closed form (linear path)", 0);
  return s;
}

Scheme generalized_alpha_scheme() {
  Scheme s{"Generalized-Alpha",
           "2",
           "linear: unconditional, spectral radius as given at infinite frequency",
           "linear momentum; energy of linear problems for Spectral Radius 1",
           "one solve a step",
           "Chung and Hulbert 1993",
           {},
           [](const List& p) { return generalized_alpha(p.get<double>("Spectral Radius")); }};
  s.parameters.set("Spectral Radius", 0.5, "spectral radius at infinite frequency [-]", between(0, 1));
  return s;
}

Scheme hht_scheme() {
  Scheme s{"HHT-Alpha",
           "2",
           "linear: unconditional, damps high frequencies",
           "linear momentum; energy of linear problems for Alpha = 0",
           "one solve a step",
           "Hilber, Hughes and Taylor 1977",
           {},
           [](const List& p) { return hht_alpha(p.get<double>("Alpha")); }};
  s.parameters.set("Alpha", -0.05, "alpha [-]; more negative damps more", between(-1.0 / 3, 0));
  return s;
}

Scheme midpoint_scheme() {
  Scheme s{"Midpoint",
           "2",
           "linear: unconditional; nonlinear: energy may grow",
           "linear and angular momentum; energy of linear problems",
           "one solve a step",
           "Simo, Tarnow and Wong 1992",
           {},
           [](const List& p) { return midpoint(p.get<std::string>("Interaction Mean") == "Exact"); }};
  s.parameters.set("Interaction Mean", "Points",
                   "the interaction in the middle, or its exact mean over the linear path, whose work is exact",
                   one_of({"Points", "Exact"}));
  return s;
}

Scheme energy_momentum_scheme() {
  return {"Energy-Momentum",
          "2",
          "energy is bounded by its conservation",
          "energy, linear and angular momentum, to the solver's tolerance; the tangent is unsymmetric",
          "one solve a step with an unsymmetric matrix: LU or GMRES",
          "Simo and Tarnow 1992; Gonzalez 2000; Gautam and Sauer 2013",
          {},
          [](const List&) { return energy_momentum(); }};
}

Scheme central_difference_scheme() {
  Scheme s{"Central Difference",
           "2",
           "conditional: steps are cut to the stable one, found from stiffness and smallest gap at every step",
           "linear and angular momentum; energy oscillates about its value",
           "no solve, a lumped mass; many short steps, a force evaluation each",
           "Newmark 1959 with beta = 0; Belytschko, Liu, Moran and Elkhodary 2014",
           {},
           [](const List& p) { return central_difference(p.get<double>("Safety")); }};
  s.parameters.set("Safety", 0.4,
                   "share of the stable step that is used [-]; near 1 a step up a stiffening wall gives energy",
                   greater_than_and_at_most(0, 1));
  return s;
}

Scheme static_scheme() {
  return {"Static",
          "exact where each step's equilibrium is",
          "none: an unstable equilibrium ends in a jump to another, or in a failed step",
          "the balance of forces; no inertia, no damping",
          "one solve a step, no mass matrix",
          "load stepping, e.g. Wriggers 2008",
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
  static const Scheme custom{"Custom",
                             "as its rows say",
                             "as its rows say",
                             "as its rows say",
                             "a solve for each stage",
                             "a table of the scene's own, stage by stage; refused unless it reproduces u = 1, t, t^2",
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
