#include "time/displacement_error.hpp"

#include <algorithm>
#include <cmath>

#include "model/branch_reports.hpp"

namespace ixos {

double displacement_error(const Model& model, const Table& table, const std::vector<State>& states, double dt,
                          const PastDisplacements& past) {
  const std::vector<double>&start = states.front().u, &end = states.back().u;
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  const double h1 = past.later_dt, h2 = past.earlier_dt;
  double largest = 0;
  const auto take = [&](std::size_t i) {
    const double now = (end[i] - start[i]) / dt;
    const double before = (start[i] - past.later[i]) / h1;
    const double first = (past.later[i] - past.earlier[i]) / h2;
    const double difference = ((now - before) / (dt + h1) - (before - first) / (h1 + h2)) / (dt + h1 + h2);
    largest = std::max(largest, std::abs(6 * difference));
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.space().owned()); ++i)
    if (!model.mesh().is_derivative(i / d) && !model.constraints().holds(static_cast<int>(i))) take(i);
  for (std::size_t k = 0; k < model.space().globals().free.size(); ++k) take(model.space().place_of_free(k));
  return std::max(std::abs(table.error_constant) * dt * dt * dt * model.space().maximum(largest),
                  history_error(model, {states.front().u.data(), nullptr, states.back().u.data(), states.front().time,
                                        dt, &states.front().histories}));
}

}  // namespace ixos
