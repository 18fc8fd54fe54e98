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
  /// `local`: the rank's degrees of freedom, ghosts included.
  explicit Loads(std::size_t local) : local_(local) {}

  /// Returns the number of the load. Throws InputError, on this rank, if the forces are no local array or there is no
  /// history; std::logic_error after Model::close(). Not collective.
  std::size_t add(std::vector<double> forces, std::shared_ptr<const TimeFunction> history);
  /// Replaces the nodal forces of a load, between steps: for forces that another solver computes. They are part of
  /// neither snapshots nor checkpoints. The change itself does no work: the next step's external work is that of the
  /// new forces, or, if the scheme's work is the mean of both ends (WorkSum::Form::EndMean), half of it that of the old
  /// ones. Throws std::out_of_range if there is no such load, InputError, on this rank, if the forces are no local
  /// array. Not collective.
  void replace(std::size_t number, std::vector<double> forces);
  /// Returns the nodal forces of a load. Throws std::out_of_range.
  const std::vector<double>& forces(std::size_t number) const { return loads_.at(number).forces; }
  /// Ends the adding, see Model::close().
  void close() const { closed_ = true; }
  bool empty() const { return loads_.empty(); }

  /// Adds factor * f_ext(time) to a local array.
  void add_force(double time, double factor, double* force) const;
  /// Adds factor * df_ext/dt(time) to a local array [E0 L0^(D-1)/T0].
  void add_rate(double time, double factor, double* force) const;
  /// Returns whether all histories are defined at `time`.
  bool are_finite(double time) const;
  /// Adds the mean sum_i weight_i f_ext(start + time_i dt).
  void add_mean(const std::vector<TimePoint>& points, double start, double dt, double* force) const;

 private:
  struct Load {
    std::vector<double> forces;
    std::shared_ptr<const TimeFunction> history;
  };
  void check(const std::vector<double>& forces) const;

  std::size_t local_;
  std::vector<Load> loads_;
  mutable bool closed_ = false;
};

}  // namespace ixos
