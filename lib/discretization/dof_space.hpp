/// Degrees of freedom: the maps, and the exchange between owned vectors and local arrays.
#pragma once
#include <vector>

#include "base/tpetra.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/node_ties.hpp"

namespace ixos {

/// Every local node carries `dimension` consecutive degrees of freedom. Owned vectors (Tpetra) hold the rank's own;
/// local arrays hold those of all local nodes, owned first, then ghosts, then tied nodes, whose displacements are no
/// degrees of freedom of the maps.
class DofSpace {
 public:
  DofSpace(const LocalMesh& mesh, const Comm& comm);
  ~DofSpace();

  int dimension() const { return dimension_; }
  int owned() const { return owned_; }  ///< degrees of freedom of owned nodes
  int local() const { return local_; }  ///< and of ghosts and tied nodes
  long long global() const { return global_; }
  const Comm& comm() const { return comm_; }
  const Teuchos::RCP<const Map>& owned_map() const { return owned_map_; }
  const Teuchos::RCP<const Map>& local_map() const { return local_map_; }

  /// Sets local = owned entries and, by a ghost exchange, their owners' values for the ghosts, and interpolates tied
  /// nodes. Collective.
  void import(const Vector& owned, double* local) const;
  /// Replaces the ghosts' entries of a local array by those of their owners (ghost exchange), and interpolates tied
  /// nodes. Collective.
  void update_ghosts(double* local) const;
  /// Interpolates the tied nodes of a local array, see NodeTies.
  void interpolate_tied(double* local) const { ties_.interpolate(local, static_cast<std::size_t>(dimension_)); }
  /// Adds the forces on tied nodes of a local array to those on their masters, and sets them to zero.
  void condense(double* local) const { ties_.condense(local, static_cast<std::size_t>(dimension_)); }
  const NodeTies& ties() const { return ties_; }
  /// Sums over ranks; no communication on one rank. Collective.
  void sum(double* values, int count) const;
  double minimum(double value) const;
  double maximum(double value) const;

 private:
  int dimension_;
  int owned_;
  int local_;
  long long global_;
  NodeTies ties_;
  Comm comm_;
  Teuchos::RCP<const Map> owned_map_;
  Teuchos::RCP<const Map> local_map_;
  Teuchos::RCP<const Import> importer_;
  Teuchos::RCP<Vector> buffer_;  ///< reused target of the import; null on one rank
};

}  // namespace ixos
