#include "study/cost_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ixos {
namespace {

/// Weight of the default powers, in samples that differ by a factor e. It decides where the samples do not.
constexpr double weight_of_defaults = 0.02;
constexpr double least_power = 0.3, largest_step_power = 1.3, largest_dof_power = 2.5;

}  // namespace

double CostModel::seconds(double steps, double dofs) const {
  return scale * std::pow(steps, step_power) * std::pow(dofs, dof_power);
}

CostModel fit_costs(const std::vector<CostSample>& samples) {
  CostModel model;
  const double b0 = model.step_power, a0 = model.dof_power;
  std::vector<std::array<double, 3>> logs;
  for (const CostSample& s : samples)
    if (s.steps > 0 && s.dofs > 0 && s.seconds > 0)
      logs.push_back({std::log(s.steps), std::log(s.dofs), std::log(s.seconds)});
  if (logs.empty()) return model;
  std::array<double, 3> mean{};
  for (const auto& row : logs)
    for (std::size_t k = 0; k < 3; ++k) mean[k] += row[k] / static_cast<double>(logs.size());
  // Normal equations of the differences from the defaults.
  double xx = weight_of_defaults, xy = 0, yy = weight_of_defaults, xz = 0, yz = 0;
  for (const auto& row : logs) {
    const double x = row[0] - mean[0], y = row[1] - mean[1], z = row[2] - mean[2] - b0 * x - a0 * y;
    xx += x * x, xy += x * y, yy += y * y, xz += x * z, yz += y * z;
  }
  const double determinant = xx * yy - xy * xy;
  model.step_power = std::clamp(b0 + (xz * yy - yz * xy) / determinant, least_power, largest_step_power);
  model.dof_power = std::clamp(a0 + (yz * xx - xz * xy) / determinant, least_power, largest_dof_power);
  model.scale = std::exp(mean[2] - model.step_power * mean[0] - model.dof_power * mean[1]);
  return model;
}

}  // namespace ixos
