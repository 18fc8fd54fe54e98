/// A model with the interaction of two surfaces.
#pragma once
#include "interaction/catalogue.hpp"
#include "interaction/van_der_waals.hpp"
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
  /// Returns the energy of all ranks. Collective.
  double energy(const std::vector<double>& u) const {
    double sum = term->energy(u.data());
    model->space().sum(&sum, 1);
    return sum;
  }
};

}  // namespace ixos::test
