/// Interactions that are looked at together: all of a model, or those of one name.
#pragma once
#include <utility>
#include <vector>

#include "discretization/dof_space.hpp"
#include "mesh/local_mesh.hpp"
#include "term/interaction.hpp"

namespace ixos {

/// Sums and nodal fields of some terms in one state. Nodal arrays are by local node, or local; they are valid for owned
/// nodes. The mesh, the space, the terms and the state must outlive the group.
class InteractionGroup {
 public:
  /// `at`: with histories, unless no term keeps any.
  InteractionGroup(const LocalMesh& mesh, const DofSpace& space, std::vector<const Interaction*> terms, const Place& at)
      : mesh_(mesh), space_(space), terms_(std::move(terms)), at_(at) {}

  /// Returns the report of all ranks. Collective.
  InteractionReport report() const;
  /// Returns the moment of the forces on the bodies about the origin, int x cross T n dA at the deformed places x: z in
  /// 2D, x, y, z in 3D; empty for an axisymmetric mesh, whose forces are summed around the ring [E0 L0^D]. Collective.
  std::vector<double> moment() const;

  /// Returns the gap to the nearest obstacle [L0]; NaN away from the surfaces. Derivative nodes have the gap's
  /// derivative.
  std::vector<double> gap() const;
  /// Returns the same with the gaps of the other bodies' surfaces.
  std::vector<double> gap_of_both() const;
  /// Returns the unit normal of the obstacle at its point nearest to the node, away from the obstacle: a local array,
  /// zero away from the surfaces and at derivative nodes. Where several terms act on a node, it is that of the last.
  std::vector<double> normal() const;
  /// Returns the traction on the bodies, nodal force over int N_a dA: a local array, zero away from the surfaces and at
  /// derivative nodes [E0]. At nodes on the axis of an axisymmetric mesh it is the pressure times the normal.
  std::vector<double> traction() const;
  /// Returns the traction along the normals, int w_a T dA over int w_a dA: positive where an obstacle pushes; zero away
  /// from the surfaces and at derivative nodes [E0]. The weight w_a is N_a, but N_a/(2 pi R) at a node on the axis of
  /// an axisymmetric mesh where int N_a dA vanishes, on contact sides of even order.
  std::vector<double> pressure() const;
  /// Returns whether some term is friction.
  bool has_friction() const;
  /// Returns the sum of the friction on the bodies, of all ranks [E0 L0^(D-1)]. Collective.
  std::vector<double> friction_force() const;
  /// Returns the report of friction of all ranks. Friction of several terms adds up. Collective.
  FrictionReport friction_report() const;
  /// Returns the part of the traction that is friction, likewise: zero on the axis.
  std::vector<double> friction() const;

  /// Returns whether one of the terms has that number. Equal on all ranks.
  bool has(SurfaceNumber number) const;
  /// Returns the nodal means of a number, with the weights of pressure(); zero away from the surfaces and at derivative
  /// nodes. Friction of several terms adds up. (On an enriched side, where N_a can be negative, a mean can be beyond
  /// the range of the points; that of a damage is then 0 or 1.)
  std::vector<double> mean(SurfaceNumber number) const;

 private:
  /// Returns the gradient of the energy of those terms that `counts` accepts, a local array.
  template <class Counts>
  std::vector<double> force(const Counts& counts) const;
  /// Returns the traction of those terms, see the public function.
  template <class Counts>
  std::vector<double> traction(const Counts& counts) const;
  /// Returns the traction of a nodal force: less that force over the measure.
  std::vector<double> over_measure(std::vector<double> force) const;
  /// Divides numbers by local node by the measure; zero at derivative nodes and away from the surfaces.
  void divide_by_measure(std::vector<double>& sums) const;
  /// Returns int w_a dA by local node; a side of several terms counts once.
  std::vector<double> measure() const;

  const LocalMesh& mesh_;
  const DofSpace& space_;
  std::vector<const Interaction*> terms_;
  Place at_;
};

}  // namespace ixos
