/// Degrees of freedom: the maps, and the exchange between owned vectors and local arrays.
#pragma once
#include <vector>

#include "base/tpetra.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/node_ties.hpp"

namespace ixos {

/// Unknowns that are no node's, such as the place of a rigid body. Their numbers stand at the end of local arrays,
/// after those of the nodes, alike on all ranks; in a local array of forces each rank has a share of them.
struct GlobalUnknowns {
  int numbers = 0;          ///< at the end of local arrays
  std::vector<int> free{};  ///< those of them that a stage solves for, from 0
};

/// Every local node carries `dimension` consecutive degrees of freedom. Owned vectors (Tpetra) hold the rank's own;
/// local arrays hold those of all local nodes, owned first, then ghosts, then tied nodes, whose displacements are no
/// degrees of freedom of the maps; then come the numbers of what is no node's. A vector of all unknowns of a stage, of
/// unknown_map(), has the owned ones and, on the first rank, the free globals after them.
class DofSpace {
 public:
  DofSpace(const LocalMesh& mesh, const Comm& comm, GlobalUnknowns globals = {});
  ~DofSpace();

  int dimension() const { return dimension_; }
  int owned() const { return owned_; }          ///< degrees of freedom of owned nodes
  int local() const { return local_; }          ///< and of ghosts, tied nodes and globals: the length of a local array
  long long global() const { return global_; }  ///< of nodes of all ranks
  /// Returns the place of the first global number in local arrays.
  int first_global() const { return local_ - globals_.numbers; }
  const GlobalUnknowns& globals() const { return globals_; }
  bool has_globals() const { return !globals_.free.empty(); }
  /// Returns the place of a free global in local arrays.
  std::size_t place_of_free(std::size_t k) const {
    return static_cast<std::size_t>(first_global()) + static_cast<std::size_t>(globals_.free[k]);
  }
  const Comm& comm() const { return comm_; }
  const Teuchos::RCP<const Map>& owned_map() const { return owned_map_; }
  const Teuchos::RCP<const Map>& local_map() const { return local_map_; }
  /// Returns the map of all unknowns of a stage: the owned one if there are no free globals.
  const Teuchos::RCP<const Map>& unknown_map() const { return unknown_map_; }

  /// Sets local = owned entries and, by a ghost exchange, their owners' values for the ghosts, and interpolates tied
  /// nodes. A vector of the unknown map sets the free globals, too. Collective.
  void import(const Vector& owned, double* local) const;
  /// Sets the entries of a vector of either map to those of a local array.
  void take(const double* local, Vector& owned) const;
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
  void import_nodes(const Vector& owned, double* local) const;

  int dimension_;
  int owned_;
  int local_;
  long long global_;
  GlobalUnknowns globals_;
  NodeTies ties_;
  Comm comm_;
  Teuchos::RCP<const Map> owned_map_;
  Teuchos::RCP<const Map> local_map_;
  Teuchos::RCP<const Map> unknown_map_;
  Teuchos::RCP<const Import> importer_;
  Teuchos::RCP<Vector> buffer_;  ///< reused target of the import; null on one rank
};

}  // namespace ixos
