#include "term/support/loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"

namespace ixos {

void Loads::check(const std::vector<double>& forces) const {
  if (forces.size() != local_)
    throw InputError(fmt::format("a load has {} forces; the rank has {} degrees of freedom, ghosts included",
                                 forces.size(), local_));
}

std::size_t Loads::add(std::vector<double> forces, std::shared_ptr<const TimeFunction> history) {
  if (closed_) throw std::logic_error("a load is added after an integrator or an evaluator was made of the model");
  check(forces);
  if (!history) throw InputError("a load has no function of time; constant(1) is one");
  loads_.push_back({std::move(forces), std::move(history)});
  return loads_.size() - 1;
}

void Loads::replace(std::size_t number, std::vector<double> forces) {
  check(forces);
  loads_.at(number).forces = std::move(forces);
}

namespace {

void add_multiple(double factor, const std::vector<double>& forces, double* sum) {
  for (std::size_t i = 0; i < forces.size(); ++i) sum[i] += factor * forces[i];
}

}  // namespace

void Loads::add_force(double time, double factor, double* force) const {
  for (const Load& load : loads_) add_multiple(factor * load.history->at(time).value, load.forces, force);
}

void Loads::add_rate(double time, double factor, double* force) const {
  for (const Load& load : loads_) add_multiple(factor * load.history->at(time).rate, load.forces, force);
}

bool Loads::are_finite(double time) const {
  return std::all_of(loads_.begin(), loads_.end(),
                     [time](const Load& load) { return std::isfinite(load.history->at(time).value); });
}

void Loads::add_mean(const std::vector<TimePoint>& points, double start, double dt, double* force) const {
  for (const TimePoint& point : points) add_force(start + point.time * dt, point.weight, force);
}

}  // namespace ixos
