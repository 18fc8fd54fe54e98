/// External forces.
#pragma once
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "histories/time_function.hpp"

namespace ixos {

/// A time in a step, in steps from its start, and its weight in a mean.
struct TimePoint {
  double time;
  double weight;
};

/// Dead loads: f_ext(t) = sum_k history_k(t) F_k with constant nodal forces F_k (local arrays, complete for owned
/// degrees of freedom) [E0 L0^(D-1)].
class Loads {
 public:
  /// Returns the number of the load.
  std::size_t add(std::vector<double> forces, std::shared_ptr<const TimeFunction> history);
  /// Replaces the nodal forces of a load, between steps: for forces that another solver computes. Throws
  /// std::out_of_range if there is no such load. The integrator does not count the change as work.
  void replace(std::size_t number, std::vector<double> forces) { loads_.at(number).forces = std::move(forces); }
  bool empty() const { return loads_.empty(); }

  /// Adds factor * f_ext(time) to a local array.
  void add_force(double time, double factor, double* force) const;
  /// Returns whether all histories are defined at `time`.
  bool are_finite(double time) const;
  /// Adds the mean sum_i weight_i f_ext(start + time_i dt).
  void add_mean(const std::vector<TimePoint>& points, double start, double dt, double* force) const;

 private:
  struct Load {
    std::vector<double> forces;
    std::shared_ptr<const TimeFunction> history;
  };
  std::vector<Load> loads_;
};

}  // namespace ixos
