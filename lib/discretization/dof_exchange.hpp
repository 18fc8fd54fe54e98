/// Vectors of a program's own numbering.
#pragma once
#include <functional>
#include <vector>

#include "base/tpetra.hpp"
#include "discretization/dof_space.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Carries vectors between a program's map and the model's. The program's map may distribute and number the degrees of
/// freedom in any way, without ghosts, and may hold further unknowns, which are left alone. Nodes that enrich() added
/// are the model's only: the program has no entries for them, and they are left alone too.
class DofExchange {
 public:
  /// Returns the program's global id of a displacement: of component `component` (0, 1, 2) of the node that the program
  /// calls `node`, see LocalMesh::program_id().
  using Number = std::function<GlobalId(GlobalId node, int component)>;

  /// The mesh and the space are a model's (Model::mesh(), Model::space()), which must outlive the exchange. Throws
  /// InputError, on all ranks, if the program's map has ghosts or lacks a number, if two displacements have the same,
  /// or, with its message, if `number` throws on any rank. Collective.
  DofExchange(const LocalMesh& mesh, const DofSpace& space, const Teuchos::RCP<const Map>& program,
              const Number& number);
  /// Makes the exchange for the number node * dimension + component.
  DofExchange(const LocalMesh& mesh, const DofSpace& space, const Teuchos::RCP<const Map>& program);
  ~DofExchange();
  DofExchange(DofExchange&&) noexcept;
  DofExchange& operator=(DofExchange&&) = delete;

  /// Copy values between a vector on the program's map and an owned one, on DofSpace::owned_map(); both have the same
  /// number of columns. Collective.
  void to_model(const MultiVector& program, MultiVector& owned) const;
  void to_program(const MultiVector& owned, MultiVector& program) const;

  /// Do the same with local arrays as a model and a State have them. to_model() resizes the array and sets the ghosts
  /// too. Collective.
  void to_model(const Vector& program, std::vector<double>& local) const;
  void to_program(const std::vector<double>& local, Vector& program) const;

 private:
  const DofSpace& space_;
  std::vector<std::size_t> places_;      ///< of the exchanged values among the owned ones
  Teuchos::RCP<const Map> aligned_;      ///< the program's numbers in the order of places_
  Teuchos::RCP<const Import> importer_;  ///< from the program's map to aligned_
};

}  // namespace ixos
