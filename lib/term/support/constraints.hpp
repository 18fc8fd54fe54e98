/// Prescribed degrees of freedom.
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "histories/rigid_motion.hpp"
#include "histories/time_function.hpp"

namespace ixos {

/// u(t) = sum_k factor_k motion_k(t) for each constrained degree of freedom; local numbers, ghosts constrained on every
/// rank that sees them. A motion is evaluated once for all its degrees of freedom.
class Constraints {
 public:
  /// Constrains a degree of freedom; without a motion it is held at zero. A constrained one may be constrained again by
  /// the same motion and factor, or held again. Throws InputError if motion or factor differ; std::logic_error after
  /// Model::close().
  void add(int dof, double factor, const std::shared_ptr<const TimeFunction>& motion);
  /// Does the same with a sum of motions; without any the degree of freedom is held at zero.
  void add(int dof, const std::vector<MotionShare>& shares);
  /// Throw the InputError of add(), and change nothing.
  void check(int dof, double factor, const std::shared_ptr<const TimeFunction>& motion) const;
  void check(int dof, const std::vector<MotionShare>& shares) const;
  /// Ends the adding, see Model::close().
  void close() const { closed_ = true; }

  bool empty() const { return entries_.empty(); }
  bool holds(int dof) const { return static_cast<std::size_t>(dof) < index_.size() && index_[dof_index(dof)] >= 0; }
  const std::vector<int>& dofs() const { return dofs_; }
  /// Returns whether any degree of freedom moves.
  bool driven() const { return driven_; }

  /// Puts displacement, velocity and acceleration at `time` into local arrays; each may be null.
  void set(double time, double* u, double* v, double* a) const;
  /// Returns whether all motions and their derivatives are defined at `time`.
  bool are_finite(double time) const;

 private:
  void push(int dof, double factor, const std::shared_ptr<const TimeFunction>& motion);
  static std::size_t dof_index(int dof) { return static_cast<std::size_t>(dof); }
  struct Entry {
    int dof;
    std::size_t motion;
    double factor;
  };
  std::vector<int> dofs_;
  std::vector<Entry> entries_;  ///< in the order of dofs_; a sum has several, one after the other
  std::vector<int> index_;      ///< by dof: its first entry, or -1
  std::vector<std::shared_ptr<const TimeFunction>> motions_;
  bool driven_ = false;
  mutable bool closed_ = false;
};

}  // namespace ixos
