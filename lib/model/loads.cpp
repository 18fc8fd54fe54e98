#include "model/loads.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ixos {

std::size_t Loads::add(std::vector<double> forces, std::shared_ptr<const TimeFunction> history) {
  loads_.push_back({std::move(forces), std::move(history)});
  return loads_.size() - 1;
}

void Loads::add_force(double time, double factor, double* force) const {
  for (const Load& load : loads_) {
    const double value = factor * load.history->at(time).value;
    for (std::size_t i = 0; i < load.forces.size(); ++i) force[i] += value * load.forces[i];
  }
}

bool Loads::are_finite(double time) const {
  return std::all_of(loads_.begin(), loads_.end(),
                     [time](const Load& load) { return std::isfinite(load.history->at(time).value); });
}

void Loads::add_mean(const std::vector<TimePoint>& points, double start, double dt, double* force) const {
  for (const TimePoint& point : points) add_force(start + point.time * dt, point.weight, force);
}

}  // namespace ixos
