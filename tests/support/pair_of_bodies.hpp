/// A model with the interaction of two surfaces.
#pragma once
#include <gtest/gtest.h>

#include "interaction/catalogue.hpp"
#include "interaction/van_der_waals.hpp"
#include "support/tangents.hpp"
#include "support/two_bodies.hpp"

namespace ixos::test {

/// A model of model_of_bodies() with one pair, whose law is that of the default wall unless another one is given.
struct PairOfBodies {
  std::unique_ptr<Model> model;
  const Interaction* term;

  PairOfBodies(const Mesh& mesh, const std::string& secondary, const std::string& primary, Smoothing smoothing,
               double cutoff = 0, std::shared_ptr<const GapLaw> law = gap_law(VanDerWaals(2.5, 25)),
               Passes passes = Passes::One, int points = 0)
      : model(model_of_bodies(mesh, {secondary, primary})) {
    SurfacePair pair;
    pair.secondary = secondary;
    pair.primary = primary;
    pair.law = std::move(law);
    pair.smoothing = smoothing;
    pair.cutoff = cutoff;
    pair.passes = passes;
    pair.points = points;
    add_pair(*model, pair);
    term = dynamic_cast<const Interaction*>(model->force_terms().back().term);
  }
  /// Returns the forces on local degrees of freedom, whose gaps are as admissible as `allowed` says.
  std::vector<double> force(const Segment& segment, const Rule& rule, bool allowed = true) const {
    std::vector<double> f(static_cast<std::size_t>(model->space().local()), 0.0);
    EXPECT_EQ(term->add_force(segment, rule, f.data()), allowed);
    return f;
  }
  /// Returns the exact tangent times x. Collective.
  std::vector<double> product(const Segment& segment, const Rule& rule, const std::vector<double>& x) const {
    std::vector<double> values = no_values(*model);
    term->add_tangent(segment, rule, Tangent::Exact, values.data());
    return matrix_product(*model, values.data(), x);
  }
  /// Returns the energy of all ranks. Collective.
  double energy(const std::vector<double>& u) const {
    double sum = term->energy(u.data());
    model->space().sum(&sum, 1);
    return sum;
  }
};

}  // namespace ixos::test
