#include "study/advice/cost_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "study/common/tuning.hpp"

namespace ixos {
namespace {

/// The logarithms of a sample.
struct Row {
  std::array<double, 3> logs;
  double weight;
};

/// Returns the weight of a run: the inverse square of the error of its time's logarithm, relative to that of a long
/// one.
double weight_of(double seconds) {
  return 1 / (1 + std::pow(tuning::time_noise / (tuning::time_accuracy * seconds), 2));
}

}  // namespace

double CostModel::seconds(double steps, double dofs) const {
  return scale * std::pow(steps, step_power) * std::pow(dofs, dof_power);
}

CostModel fit_costs(const std::vector<CostSample>& samples) {
  CostModel model;
  const double b0 = model.step_power, a0 = model.dof_power;
  std::vector<Row> rows;
  double weights = 0;
  for (const CostSample& s : samples) {
    if (!(s.steps > 0 && s.dofs > 0 && s.seconds > 0)) continue;
    rows.push_back({{std::log(s.steps), std::log(s.dofs), std::log(s.seconds)}, weight_of(s.seconds)});
    weights += rows.back().weight;
  }
  if (rows.empty()) return model;
  std::array<double, 3> mean{};
  for (const Row& row : rows)
    for (std::size_t k = 0; k < 3; ++k) mean[k] += row.weight / weights * row.logs[k];
  // Normal equations of the differences from the defaults.
  double xx = tuning::weight_of_defaults, xy = 0, yy = tuning::weight_of_defaults, xz = 0, yz = 0;
  for (const auto& [logs, w] : rows) {
    const double x = logs[0] - mean[0], y = logs[1] - mean[1], z = logs[2] - mean[2] - b0 * x - a0 * y;
    xx += w * x * x, xy += w * x * y, yy += w * y * y, xz += w * x * z, yz += w * y * z;
  }
  const double determinant = xx * yy - xy * xy;
  model.step_power =
      std::clamp(b0 + (xz * yy - yz * xy) / determinant, tuning::least_cost_power, tuning::largest_step_power);
  model.dof_power =
      std::clamp(a0 + (yz * xx - xz * xy) / determinant, tuning::least_cost_power, tuning::largest_dof_power);
  model.scale = std::exp(mean[2] - model.step_power * mean[0] - model.dof_power * mean[1]);
  return model;
}

}  // namespace ixos
