#include "rule/row_on_states.hpp"

#include <algorithm>

namespace ixos {

void evaluate_known(const Row& row, const std::vector<KnownState>& states, double dt, std::vector<double>& result) {
  std::fill(result.begin(), result.end(), 0.0);
  for (std::size_t j = 0; j < row.known.size(); ++j) {
    const Row::Known& k = row.known[j];
    const KnownState& state = states[j];
    if (k.u != 0 && j > 0)
      for (std::size_t i = 0; i < result.size(); ++i) result[i] += k.u * (state.u[i] - states[0].u[i]);
    if (k.v != 0)
      for (std::size_t i = 0; i < result.size(); ++i) result[i] += k.v * dt * state.v[i];
    if (k.a != 0)
      for (std::size_t i = 0; i < result.size(); ++i) result[i] += k.a * dt * dt * state.a[i];
  }
}

void evaluate(double s, const double* u, const double* u0, const std::vector<double>& known,
              std::vector<double>& result) {
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = s * (u[i] - u0[i]) + known[i];
}

}  // namespace ixos
