/// The rigid bodies of a model in a stage of a scheme.
#pragma once
#include <array>
#include <vector>

#include "model/model.hpp"
#include "rule/row_on_states.hpp"
#include "term/border.hpp"
#include "time/table.hpp"

namespace ixos {

/// The balance of each body's numbers: its inertia, as the stage's rows make it, and the forces on it. Translations are
/// as all displacements. A rotation w since the step's start, see RigidBody, obeys
/// - in schemes that balance momentum over the step (Closing::Collocate), J (s - s_0)/dt + (w/dt) x p, where the row of
///   velocities gives the spin s, and p is the mean over both ends of (I + Q)/2 and its transpose times J s: it is the
///   balance of the angular momentum in space, seen from the body. With w/dt = (s_0 + s)/2 the second part does no work
///   (Simo and Wong 1991), so that energy and momentum are those of the forces;
/// - in all others, the equation of motion by w, w' and w'' from the rows, J w'' + N: each keeps its order (the local
///   chart of Munthe-Kaas 1999).
/// Everything here is alike on all ranks.
class BodyStage {
 public:
  /// Collective.
  explicit BodyStage(const Model& model);

  /// Returns the largest distance of a node from the centre of a body that turns, in units of that body's length: by
  /// how much forces and their rounding count more in the balance of w. At least 1, equal on all ranks.
  double reach() const { return reach_; }

  /// As StageProblem::arm().
  void arm(const Table& table, std::size_t stage, const std::vector<KnownState>& known, double dt);
  /// Adds the inertia at a displacement to `forces`, by number; u and the inertia's bracket are local arrays.
  void add_inertia(const double* u, const double* bracket, double* forces) const;
  /// Adds to `forces`, by number, what a moment, which is among the loads on w, does less on w than on the angle
  /// 2 atan(|w|/2): w' turns the body by 1/(1 + |w|^2/4) only. A moment acts about one axis. Nothing in schemes that
  /// balance momentum. `load`: a local array.
  void add_moments(const double* u, const double* load, double* forces) const;
  /// Adds its derivatives, and returns its potential.
  void add_moments(const double* u, const double* load, Border& border) const;
  double moment_potential(const double* u, const double* load) const;
  /// Returns the sum of squares of the bodies' masses times x, a local array.
  double square_of_inertia(const double* x) const;
  /// Adds its derivatives.
  void add_inertia(const double* u, Border& border) const;

 private:
  using Triple = std::array<double, 3>;
  /// Calls visit(body, place of its first number among all) for each body to whose loads that applies.
  template <class Visit>
  void for_each_turning(const Visit& visit) const;
  template <class T>
  std::array<T, 3> turning(std::size_t body, const std::array<T, 3>& w) const;

  const Model& model_;
  std::size_t first_;
  const Stage* stage_ = nullptr;
  double reach_ = 1;
  bool momentum_ = false;
  bool has_inertia_ = false;
  double dt_ = 0;
  double start_share_ = 0;        ///< of the start in the force
  std::vector<double> velocity_;  ///< what the row of velocities has without the unknown, by number
  std::vector<double> acceleration_;
  std::vector<Triple> start_spin_;  ///< by body
};

}  // namespace ixos
