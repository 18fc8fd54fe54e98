#include "time/step_error.hpp"

#include <algorithm>
#include <cmath>

#include "model/branch_reports.hpp"

namespace ixos {

double local_error(const Model& model, const Table& table, const std::vector<State>& states, double dt,
                   const PreviousVelocity& previous) {
  const State& start = states.front();
  const State& end = states.back();
  const bool embedded = states.size() > 2;
  const double g = table.stages.front().end;
  const auto third_derivative = [&](std::size_t i) {
    const double v0 = start.v[i], v1 = end.v[i];
    if (embedded) return 2 * ((v1 - states[1].v[i]) / (1 - g) - (states[1].v[i] - v0) / g) / (dt * dt);
    if (!previous.known) return 2 * ((v1 - v0) / dt - start.a[i]) / dt;
    return 2 * ((v1 - v0) / dt - (v0 - previous.v[i]) / previous.dt) / (dt + previous.dt);
  };
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  double largest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.space().owned()); ++i)
    if (!model.mesh().is_derivative(i / d) && !model.constraints().holds(static_cast<int>(i)))
      largest = std::max(largest, std::abs(third_derivative(i)));
  for (std::size_t k = 0; k < model.space().globals().free.size(); ++k)
    largest = std::max(largest, std::abs(third_derivative(model.space().place_of_free(k))));
  return std::max(std::abs(table.error_constant) * dt * dt * dt * model.space().maximum(largest),
                  history_error(model, {states.front().u.data(), nullptr, states.back().u.data(), states.front().time,
                                        dt, &states.front().histories}));
}

}  // namespace ixos
