/// Directions and runs of an advice on a scene that is a formula.
#pragma once
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "study/advice/advice_point.hpp"

namespace ixos::test {

/// Five steps of two schemes, four meshes of two elements, and two tolerances of Newton's method.
inline AdviceDirections directions_of_formula() {
  AdviceDirections directions;
  std::vector<AdviceLevel> steps, meshes;
  for (int k = 0; k < 5; ++k) {
    const double dt = std::pow(2.0, -k);
    steps.push_back({std::to_string(1 << k), dt, {"Step=" + std::to_string(dt)}});
    if (k < 4) meshes.push_back({std::to_string(4 << k), dt, {"Mesh=" + std::to_string(4 << k)}});
  }
  directions.all = {
      {"time step", {{"N", {}, steps}, {"B", {"Scheme=B"}, steps}}, 1, true},
      {"mesh", {{"Q1", {}, meshes}, {"Q2", {"Element=Q2"}, meshes}}, 2, true},
      {"tolerance", {{"1e-11", {}, {{"", 1, {}}}}, {"1e-6", {"Tolerance=1e-6"}, {{"", 1, {}}}}}, 0, false}};
  return directions;
}

/// The value of a point, given the sizes of its step and mesh and its branches.
using AdviceFormula = std::function<double(double dt, double h, const AdvicePoint& point)>;

/// Returns a good run of a point with one quantity. It costs dt^-1 h^-2.4 milliseconds. The columns of other models
/// differ by as much as the numbers.
inline AdviceSample sample_of(const AdviceDirections& directions, const AdvicePoint& point,
                              const AdviceFormula& formula) {
  const double dt = level_at(directions, point, time_direction).size;
  const double h = level_at(directions, point, mesh_direction).size;
  AdviceSample sample;
  sample.point = point;
  sample.good = true;
  sample.values = {formula(dt, h, point)};
  sample.seconds = 1e-3 / dt * std::pow(h, -2.4);
  sample.steps = 1 / dt;
  sample.dofs = 100 / (h * h);
  for (std::size_t d = 0; d < point.size(); ++d) {
    if (!replaces_model(directions, d, point[d].branch)) continue;
    AdvicePoint own = point;
    own[d].branch = 0;
    const double value = formula(dt, h, own);
    sample.comparisons.push_back({d, {std::abs(sample.values[0] - value) / std::abs(value)}});
  }
  return sample;
}

/// Returns a run of a point that did not reach its end.
inline AdviceSample failed_sample(const AdvicePoint& point) {
  AdviceSample sample;
  sample.point = point;
  sample.reason = "diverged";
  return sample;
}

/// Returns the good runs with all levels up to these on the lines of a branch of time and mesh through a base.
inline std::vector<AdviceSample> cross(const AdviceDirections& directions, const AdvicePoint& base, std::size_t steps,
                                       std::size_t meshes, const AdviceFormula& formula) {
  std::vector<AdviceSample> samples;
  for (std::size_t d : {time_direction, mesh_direction})
    for (std::size_t level = 0; level <= (d == time_direction ? steps : meshes); ++level) {
      AdvicePoint point = base;
      point[d].level = level;
      if (d == mesh_direction && point == base) continue;
      samples.push_back(sample_of(directions, point, formula));
    }
  return samples;
}

}  // namespace ixos::test
