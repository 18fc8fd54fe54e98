#include "solve/newton/forcing_term.hpp"

#include <algorithm>

namespace ixos {

double ForcingTerm::operator()(int iteration, double norm, double bound) {
  constexpr double first = 1e-3, least = 1e-8;
  double eta = first;
  if (iteration > 0 && previous_norm_ > 0) {
    const double gain = norm / previous_norm_;
    eta = std::min(first, 0.9 * gain * gain);
  }
  previous_norm_ = norm;
  if (norm > 0) eta = std::max(eta, 0.1 * bound / norm);
  return std::min(first, std::max(eta, least));
}

}  // namespace ixos
