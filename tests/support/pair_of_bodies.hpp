/// A model with the interaction of two surfaces.
#pragma once
#include <gtest/gtest.h>

#include "interaction/catalogue.hpp"
#include "interaction/van_der_waals.hpp"
#include "support/by_hand.hpp"
#include "support/tangents.hpp"
#include "support/two_bodies.hpp"
#include "term/pair/pair_gradient.hpp"

namespace ixos::test {

/// A model of model_of_bodies() with one pair, whose law is that of the default wall unless another one is given.
struct PairOfBodies {
  std::unique_ptr<Model> model;
  Interaction* term;
  SurfacePair pair;
  std::unique_ptr<ByHand<Interaction>> steps;  ///< of the term

  PairOfBodies(const Mesh& mesh, const std::string& secondary, const std::string& primary, Smoothing smoothing,
               double cutoff = 0, std::shared_ptr<const GapLaw> law = gap_law(VanDerWaals(2.5, 25)),
               Passes passes = Passes::One, int points = 0, const Friction& friction = {})
      : model(model_of_bodies(mesh, {secondary, primary})) {
    pair.side_set = secondary;
    pair.primary = primary;
    pair.law = std::move(law);
    pair.smoothing = smoothing;
    pair.cutoff = cutoff;
    pair.passes = passes;
    pair.points = points;
    pair.friction = friction;
    add_pair(*model, pair);
    term = model->interactions().back().term;
    steps = std::make_unique<ByHand<Interaction>>(*term, *model);
  }
  /// Returns the forces on local degrees of freedom, whose gaps are as admissible as `allowed` says.
  std::vector<double> force(const Segment& segment, const Rule& rule, bool allowed = true) const {
    std::vector<double> f(static_cast<std::size_t>(model->space().local()), 0.0);
    EXPECT_EQ(term->add_force(steps->in(segment), rule, f.data()), allowed);
    return f;
  }
  /// Returns the exact tangent times x, of one pass with the blocks that the matrix leaves out. Collective.
  std::vector<double> product(const Segment& segment, const Rule& rule, const std::vector<double>& x) const {
    if (pair.passes != Passes::One) return matrix_times(segment, rule, x);
    return model->mesh().dimension == 2 ? blocks_times<2>(segment, rule, x) : blocks_times<3>(segment, rule, x);
  }
  /// Returns the matrix of the exact tangent times x. Collective.
  std::vector<double> matrix_times(const Segment& segment, const Rule& rule, const std::vector<double>& x) const {
    std::vector<double> values = no_values(*model);
    term->add_tangent(steps->in(segment), rule, Tangent::Exact, values.data());
    return matrix_product(*model, values.data(), x);
  }
  template <std::size_t D>
  std::vector<double> blocks_times(const Segment& segment, const Rule& rule, const std::vector<double>& x) const {
    const LocalMesh& mesh = model->mesh();
    const auto surface = [&](const std::string& set) {
      return surface_patches<D>(mesh, mesh.whole_side_sets.at(set), pair.smoothing, set);
    };
    PairSurfaces<D> surfaces{surface(pair.side_set), surface(pair.primary)};
    PairOptions options{pair.points};
    options.depth = model->space().maximum(overlap_depth(mesh, surfaces.primary));
    const PairPoints<D> points(mesh, std::move(surfaces), pair.cutoff > 0 ? pair.law->cut_off(pair.cutoff) : pair.law,
                               options);
    std::vector<double> y(x.size(), 0.0);
    const auto add = [&](const PairBlock& block) {
      const std::size_t size = D * block.nodes.size();
      const auto dof = [&](std::size_t k) { return D * static_cast<std::size_t>(block.nodes[k / D]) + k % D; };
      for (std::size_t r = 0; r < size; ++r)
        for (std::size_t c = 0; c < size; ++c) y[dof(r)] += block.k[r * size + c] * x[dof(c)];
    };
    if (rule.mean == Mean::DiscreteGradient)
      PairGradient<D>(points).for_each_block(segment, Tangent::Exact, add);
    else
      points.for_each_block(segment, rule, Tangent::Exact, add);
    y.resize(static_cast<std::size_t>(model->space().owned()));
    return y;
  }
  /// Returns the energy of all ranks. Collective.
  double energy(const std::vector<double>& u) const {
    double sum = term->energy(steps->at(u.data()));
    model->space().sum(&sum, 1);
    return sum;
  }
};

}  // namespace ixos::test
