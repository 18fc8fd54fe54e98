// The discrete gradient of two surfaces.
#include "term/pair/pair_gradient.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/pair_of_bodies.hpp"
#include "support/simplices.hpp"
#include "support/tangents.hpp"
#include "term/pair/pair_points.hpp"

namespace ixos {
namespace {

/// A model with one pair, and two displacements between which the bodies come nearer and slide.
struct Bodies : test::PairOfBodies {
  std::vector<double> from, to;

  Bodies(const Mesh& mesh, const std::string& secondary, const std::string& primary, Smoothing smoothing,
         double cutoff = 0)
      : PairOfBodies(mesh, secondary, primary, smoothing, cutoff),
        from(test::smooth_field(*model, 0.02)),
        to(test::smooth_field(*model, -0.03)) {}
  std::vector<double> force(const std::vector<double>& end) const {
    std::vector<double> f(end.size(), 0.0);
    EXPECT_TRUE(term->add_force({from.data(), nullptr, end.data()}, discrete_gradient_rule(), f.data()));
    return f;
  }
};

std::vector<Bodies> cases() {
  std::vector<Bodies> all;
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom, Smoothing::Spline}) {
    all.emplace_back(test::two_disks(3, {5, 3.6}), "a_surface", "b_surface", smoothing);
    all.emplace_back(test::two_blocks(0.3), "lower_surface", "upper_surface", smoothing);
    all.emplace_back(test::two_balls(2, {2.4, 2, 2.9}), "a_surface", "b_surface", smoothing);
    all.emplace_back(test::two_boxes(0.3), "upper_bottom", "lower_top", smoothing, 1.0);
    if (smoothing == Smoothing::Spline) continue;
    all.emplace_back(test::split_cells(test::two_balls(2, {2.4, 2, 2.9}), "twelve tetrahedra"), "a_surface",
                     "b_surface", smoothing);
    all.emplace_back(test::split_cells(test::two_boxes(0.3), "hexahedra and prisms"), "upper_bottom", "lower_top",
                     smoothing, 1.0);
  }
  return all;
}

TEST(PairGradientTest, ItsWorkIsTheChangeOfTheEnergy) {
  for (const Bodies& bodies : cases()) {
    const std::vector<double> f = bodies.force(bodies.to);
    double sums[2] = {0, 0};
    for (std::size_t k = 0; k < static_cast<std::size_t>(bodies.model->space().owned()); ++k) {
      sums[0] += f[k] * (bodies.to[k] - bodies.from[k]);
      sums[1] += std::abs(f[k] * (bodies.to[k] - bodies.from[k]));
    }
    bodies.model->space().sum(sums, 2);
    EXPECT_NEAR(sums[0], bodies.energy(bodies.to) - bodies.energy(bodies.from), 1e-13 * (1 + sums[1]));
    EXPECT_GT(sums[1], 1e-4);
  }
}

/// Returns the net force and the net moment about the mean places, over the sum of forces and moments of parts.
std::array<double, 2> net(const Bodies& bodies) {
  const std::vector<double> f = bodies.force(bodies.to);
  const auto& x = bodies.model->mesh().coordinates;
  const auto d = static_cast<std::size_t>(bodies.model->mesh().dimension);
  double sums[5] = {0, 0, 0, 0, 0};
  for (std::size_t k = 0; k < static_cast<std::size_t>(bodies.model->space().owned()); k += d) {
    const auto mean = [&](std::size_t i) { return x[k + i] + (bodies.from[k + i] + bodies.to[k + i]) / 2; };
    for (std::size_t i = 0; i < d; ++i) {
      sums[i] += f[k + i];
      sums[4] += std::abs(f[k + i]);
    }
    sums[3] += mean(d - 2) * f[k + d - 1] - mean(d - 1) * f[k + d - 2];
  }
  bodies.model->space().sum(sums, 5);
  const double force = std::max({std::abs(sums[0]), std::abs(sums[1]), d == 3 ? std::abs(sums[2]) : 0.0});
  return {force / sums[4], std::abs(sums[3]) / (5 * sums[4])};
}

TEST(PairGradientTest, ItsNetForceAndItsNetMomentVanish) {
  for (const Bodies& bodies : cases()) {
    const auto [force, moment] = net(bodies);
    EXPECT_LT(force, 1e-13);
    EXPECT_LT(moment, 1e-13);
  }
}

TEST(PairGradientTest, ItsTangentIsItsDerivative) {
  for (const Bodies& bodies : cases()) {
    const std::vector<double> way = test::noise(*bodies.model, 1);
    const double h = 1e-7;
    const auto up = bodies.force(test::moved(bodies.to, h, way)), down = bodies.force(test::moved(bodies.to, -h, way));
    const Model& model = *bodies.model;
    const std::vector<double> product =
        bodies.product({bodies.from.data(), nullptr, bodies.to.data()}, discrete_gradient_rule(), way);
    double largest = 0;
    for (const double value : product) largest = std::max(largest, std::abs(value));
    largest = model.space().maximum(largest);
    EXPECT_GT(largest, 1e-3);
    for (std::size_t k = 0; k < product.size(); ++k)
      EXPECT_NEAR((up[k] - down[k]) / (2 * h), product[k], 1e-5 * largest);
  }
}

/// As the upper body slides, closest points cross the sides within triangles and those between them. The force does not
/// jump: its largest change falls with the way.
TEST(PairGradientTest, ItGoesOnAcrossThePartsOfTriangles) {
  const Bodies bodies(test::split_cells(test::two_boxes(0.3), "tetrahedra"), "upper_bottom", "lower_top",
                      Smoothing::CatmullRom, 1.0);
  const LocalMesh& mesh = bodies.model->mesh();
  const auto largest_change = [&](double step, int steps) {
    std::vector<double> before;
    double largest = 0;
    for (int k = 0; k <= steps; ++k) {
      std::vector<double> to = bodies.to;
      for (std::size_t i = 0; i < to.size(); i += 3)
        if (mesh.coordinates[i + 2] > 0.1) {
          to[i] += 2 * (0.15 + k * step);  // twice, because the closest points are those of the mean places
          to[i + 1] += k * step;
        }
      const std::vector<double> f = bodies.force(to);
      for (std::size_t i = 0; i < before.size(); ++i) largest = std::max(largest, std::abs(f[i] - before[i]));
      before = f;
    }
    return bodies.model->space().maximum(largest);
  };
  const double coarse = largest_change(0.002, 50), fine = largest_change(0.0002, 500);
  EXPECT_LT(fine, coarse / 5);
  EXPECT_GT(coarse, 1e-4);
}

/// The secondary disk rolls about the closest point of one of its points, which keeps its distance from the closest
/// point, as the corners of its side do. The point's energy changes, because the curvature does, and yet no moment
/// acts.
TEST(PairGradientSerialTest, APointThatRollsHasNoMoment) {
  Bodies bodies(test::two_disks(3, {5, 3.6}), "a_surface", "b_surface", Smoothing::CatmullRom);
  const LocalMesh& mesh = bodies.model->mesh();
  const auto surface = [&](const char* set) {
    return surface_patches<2>(mesh, mesh.whole_side_sets.at(set), Smoothing::CatmullRom, set);
  };
  const PairPoints<2> points(mesh, {surface("a_surface"), surface("b_surface")}, gap_law(VanDerWaals(2.5, 25)), {});
  const std::vector<double> rest = test::at_rest(*bodies.model);
  const auto contacts = points.contacts({points.places(rest.data())}, PairPoints<2>::Share::All);
  const auto nearest =
      std::min_element(contacts->front().all.begin(), contacts->front().all.end(),
                       [](const auto& a, const auto& b) { return a.projection.gap < b.projection.gap; });
  const Vec<2> projection = nearest->projection.frame.place;
  const auto turned = [&](double angle) {
    std::vector<double> u = rest;
    const double c = std::cos(angle), s = std::sin(angle);
    for (std::size_t k = 0; k < u.size(); k += 2) {
      const double x = mesh.coordinates[k] - projection[0], y = mesh.coordinates[k + 1] - projection[1];
      if (mesh.original_ids[k / 2] >= mesh.nodes() / 2) continue;  // of the primary disk
      u[k] = (c - 1) * x - s * y;
      u[k + 1] = s * x + (c - 1) * y;
    }
    return u;
  };
  bodies.from = turned(-0.02);
  bodies.to = turned(0.02);
  const auto [force, moment] = net(bodies);
  EXPECT_LT(force, 1e-13);
  EXPECT_LT(moment, 1e-13);
}

/// At rest it is the force, and its limit has no jump.
TEST(PairGradientTest, WithoutAChangeItIsTheForce) {
  for (Bodies& bodies : cases()) {
    bodies.from = bodies.to;
    const std::vector<double> f = bodies.force(bodies.to);
    std::vector<double> g(f.size(), 0.0);
    bodies.term->add_force({nullptr, nullptr, bodies.to.data()}, end_rule(), g.data());
    const std::vector<double> way = test::noise(*bodies.model, 1e-5);
    std::vector<double> near = bodies.to;
    for (std::size_t k = 0; k < near.size(); ++k) near[k] += way[k];
    const std::vector<double> after = bodies.force(near);
    double largest = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(bodies.model->space().owned()); ++k)
      largest = std::max(largest, std::abs(g[k]));
    largest = bodies.model->space().maximum(largest);
    for (std::size_t k = 0; k < static_cast<std::size_t>(bodies.model->space().owned()); ++k) {
      EXPECT_NEAR(f[k], g[k], 1e-12 * largest);
      EXPECT_NEAR(after[k], g[k], 2e-2 * largest);
    }
  }
}

}  // namespace
}  // namespace ixos
