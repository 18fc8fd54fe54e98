/// Two bodies whose surfaces rub on each other.
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "support/by_hand.hpp"
#include "support/simplices.hpp"
#include "support/tangents.hpp"
#include "support/two_bodies.hpp"
#include "term/friction_fixture.hpp"

namespace ixos::test {

/// A model with one pair; its last term is the friction.
struct Rubbing {
  std::unique_ptr<Model> model;
  Interaction* term;
  std::unique_ptr<ByHand<Interaction>> steps;  ///< of the term
  std::vector<double> between;                 ///< twice a point between the bodies, seen from the origin

  Rubbing(const Mesh& mesh, const std::string& secondary, const std::string& primary, std::vector<double> center,
          FrictionType type, Smoothing smoothing = Smoothing::CatmullRom, Passes passes = Passes::One)
      : model(model_of_bodies(mesh, {secondary, primary})), between(std::move(center)) {
    SurfacePair pair;
    pair.side_set = secondary;
    pair.primary = primary;
    pair.law = gap_law(VanDerWaals(2.5, 25));
    pair.smoothing = smoothing;
    pair.passes = passes;
    pair.friction = test::friction(type, false);
    add_pair(*model, pair);
    std::vector<int> all(static_cast<std::size_t>(model->mesh().nodes()));
    std::iota(all.begin(), all.end(), 0);
    model->couple({all});  // the pair's own coupling leaves out what is far
    term = model->interactions().back().term;
    steps = std::make_unique<ByHand<Interaction>>(*term, *model);
    steps->initialize(at_rest(*model).data());
  }
  std::vector<double> force(const Segment& segment, const Rule& rule) const {
    std::vector<double> f(static_cast<std::size_t>(model->space().local()), 0.0);
    EXPECT_TRUE(term->add_force(steps->in(segment), rule, f.data()));
    return f;
  }
  /// Moves to u in a step of length 1.
  double step(const std::vector<double>& from, const std::vector<double>& to) const {
    return steps->step(from.data(), to.data(), 0, 1).dissipated;
  }
  double total(double value) const {
    model->space().sum(&value, 1);
    return value;
  }
  bool is_second(std::size_t dof) const {
    const std::size_t d = between.size(), node = dof / d * d;
    double along = 0;
    for (std::size_t i = 0; i < d; ++i) along += between[i] * (model->mesh().coordinates[node + i] - between[i] / 2);
    return along > 0;
  }
  /// Returns a displacement: the second body moves across the line between both, and both deform.
  std::vector<double> slid(double way, double size) const {
    std::vector<double> u = smooth_field(*model, size);
    const std::size_t d = between.size();
    const double length = std::hypot(between[0], between[d - 1]);
    for (std::size_t k = 0; k < u.size(); k += d) {
      if (!is_second(k)) continue;
      u[k] += way * between[d - 1] / length;
      u[k + d - 1] -= way * between[0] / length;
    }
    return u;
  }
  /// Returns the force on the second body between steps; the third component is 0 in the plane.
  Vec<3> force_on_second(const std::vector<double>& u) const {
    const std::size_t d = between.size();
    const std::vector<double> f = force({nullptr, nullptr, u.data()}, end_rule());
    Vec<3> sum{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(model->space().owned()); ++k)
      if (is_second(k)) sum[k % d] += f[k];
    return {total(sum[0]), total(sum[1]), total(sum[2])};
  }
};

inline constexpr FrictionType friction_types[] = {FrictionType::ConstantStress, FrictionType::ExtendedAmontons,
                                                  FrictionType::Smoothed};

/// Two blocks, boxes, disks and balls near the equilibrium gap.
inline std::vector<Rubbing> rubbing_bodies(FrictionType type, Smoothing smoothing = Smoothing::CatmullRom) {
  std::vector<Rubbing> all;
  all.emplace_back(two_blocks(0.26), "upper_bottom", "lower_top", std::vector<double>{0, 0.2}, type, smoothing);
  all.emplace_back(two_boxes(0.26), "upper_bottom", "lower_top", std::vector<double>{0, 0, 0.2}, type, smoothing);
  all.emplace_back(two_disks(3, {5, 3.72}), "a_surface", "b_surface", std::vector<double>{5, 3.72}, type, smoothing);
  all.emplace_back(two_balls(2, {2.37, 1.97, 2.8}, 4, 1), "a_surface", "b_surface",
                   std::vector<double>{2.37, 1.97, 2.8}, type, smoothing);
  if (smoothing != Smoothing::Spline)
    all.emplace_back(split_cells(two_boxes(0.26), "tetrahedra"), "upper_bottom", "lower_top",
                     std::vector<double>{0, 0, 0.2}, type, smoothing);
  return all;
}

}  // namespace ixos::test
