/// Nodes that a rigid body carries: those of a grip that belongs to it.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "mesh/local_mesh.hpp"
#include "rigid/body_sight.hpp"
#include "rigid/rigid_body.hpp"

namespace ixos {

/// The nodes follow u = T + (R - I)(X - C), derivative nodes without T. Arrays are local; the body's numbers stand in
/// them from `first` on. The forces on the nodes act on the body.
class CarriedNodes {
 public:
  /// `nodes`: local, ghosts included, none tied. The body must outlive it.
  CarriedNodes(const LocalMesh& mesh, const RigidBody& body, std::size_t first, const std::vector<int>& nodes);

  const RigidBody& body() const { return *body_; }
  std::size_t first() const { return first_; }
  /// Sets the displacements of the nodes.
  void place(double* u) const;
  /// Set the velocities, and the accelerations, of the nodes of an accepted state, in which the numbers of the body
  /// have the spin and its rate.
  void move(const double* u, double* v) const;
  void accelerate(const double* u, const double* v, double* a) const;
  /// Sets the nodes' part of a direction, to first order.
  void direct(const double* u, double* direction) const;

  /// Returns how forces act in a step to u, of which `start` is the start, or null in a state and for forces that are
  /// derivatives of a potential by u.
  BodySight sight(const double* start, const double* u) const;
  /// Adds the forces on the body's numbers to `sums`, by number of the body: f has the forces on owned nodes.
  void add_forces(const BodySight& sight, const double* f, double* sums) const;

  /// A node's part in the border: how it moves with the body's freedoms T and w, and how forces on it act on them.
  struct Share {
    std::size_t place;  ///< of its first degree of freedom
    bool owned;
    std::array<std::array<double, 3>, 6> motions, moments;
  };
  std::vector<Share> shares(const BodySight& sight) const;
  /// Returns the derivatives of the forces on T and w by w that the turning of arms makes: f as above, this rank's
  /// share.
  Small<double, 6> turning(const BodySight& sight, const double* f) const;

 private:
  using Triple = std::array<double, 3>;
  struct Node {
    std::size_t place;
    bool owned, derivative;
    Triple arm;  ///< X - C, or the derivative of X
  };
  template <class OfArm>
  void set(const Triple& of_body, const OfArm& of_arm, double* to) const;
  Triple arm(const BodySight& sight, const Node& node) const { return turned(sight.forces(), node.arm); }

  const RigidBody* body_;
  std::size_t first_, d_;
  std::vector<Node> nodes_;
};

}  // namespace ixos
