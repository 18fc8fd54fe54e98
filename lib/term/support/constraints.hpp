/// Prescribed degrees of freedom.
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "histories/rigid_motion.hpp"
#include "histories/time_function.hpp"
#include "term/support/node_planes.hpp"

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
  /// Constrains a degree of freedom whose value follows what is no node's: set() leaves it as it is. Throws InputError
  /// if a condition moves or holds it; std::logic_error after Model::close().
  void entrust(int dof);
  /// Keeps a node in a plane through it: normal . u = 0. It may have several planes; a component that a condition holds
  /// at zero stays so. `dimension`: that of the space. Throws InputError if a condition moves the node across the
  /// plane; check() and add() throw it where the plane was first. Throws std::logic_error after Model::close().
  void hold_in_plane(int node, std::size_t dimension, const Vec<3>& normal);
  /// Throws the InputError of hold_in_plane().
  void check_plane(int node, std::size_t dimension, const Vec<3>& normal) const;
  /// Ends the adding, see Model::close().
  void close() const { closed_ = true; }

  bool empty() const { return entries_.empty() && planes_.empty(); }
  bool holds(int dof) const { return static_cast<std::size_t>(dof) < index_.size() && index_[dof_index(dof)] >= 0; }
  /// Returns the sum of motions that moves a degree of freedom; none if no condition does.
  std::vector<MotionShare> shares(int dof) const;
  /// Returns whether a degree of freedom is held by that sum of motions; without any, at zero.
  bool holds_by(int dof, const std::vector<MotionShare>& shares) const;
  /// Returns whether a node stays in a plane of that normal: by its planes and the components that are held at zero.
  bool holds_in_plane(int node, std::size_t dimension, const Vec<3>& normal) const;
  const std::vector<int>& dofs() const { return dofs_; }
  /// Returns those of dofs() that set() sets, and the others, which are entrusted.
  const std::vector<int>& prescribed() const { return prescribed_; }
  const std::vector<int>& entrusted() const { return entrusted_; }
  const NodePlanes& planes() const { return planes_; }
  /// Returns whether any degree of freedom moves.
  bool driven() const { return driven_; }

  /// Puts displacement, velocity and acceleration at `time` into local arrays; each may be null. Nodes in planes stay
  /// as they are.
  void set(double time, double* u, double* v, double* a) const;
  /// Returns whether all motions and their derivatives are defined at `time`.
  bool are_finite(double time) const;

 private:
  bool moves(int dof) const;
  void refuse_closed() const;
  void push(int dof, double factor, const std::shared_ptr<const TimeFunction>& motion);
  static std::size_t dof_index(int dof) { return static_cast<std::size_t>(dof); }
  struct Entry {
    int dof;
    std::size_t motion;
    double factor;
  };
  std::vector<int> dofs_, prescribed_, entrusted_;
  std::vector<Entry> entries_;  ///< in the order of dofs_; a sum has several, one after the other
  std::vector<int> index_;      ///< by dof: its first entry, or -1
  std::vector<std::shared_ptr<const TimeFunction>> motions_;
  NodePlanes planes_;
  std::size_t dimension_ = 0;  ///< of the space, if there are planes
  bool driven_ = false;
  mutable bool closed_ = false;
};

}  // namespace ixos
