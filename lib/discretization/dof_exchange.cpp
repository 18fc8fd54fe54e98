#include "discretization/dof_exchange.hpp"

#include <fmt/format.h>

#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <string>

#include "base/agreement.hpp"
#include "base/error.hpp"

namespace ixos {
namespace {

/// Throws InputError, on all ranks, if the map lacks one of the numbers, those of the displacements at `places`.
void refuse_missing(const Map& program, const std::vector<GlobalId>& numbers, const std::vector<std::size_t>& places,
                    const LocalMesh& mesh, const Comm& comm) {
  std::vector<int> owners(numbers.size(), -1);
  const Teuchos::ArrayView<const GlobalId> asked(numbers.data(), static_cast<int>(numbers.size()));
  program.getRemoteIndexList(asked, Teuchos::ArrayView<int>(owners.data(), static_cast<int>(owners.size())));
  together<InputError>(comm, [&] {
    for (std::size_t i = 0; i < owners.size(); ++i) {
      if (owners[i] >= 0) continue;
      const std::size_t node = places[i] / static_cast<std::size_t>(mesh.dimension);
      std::string text = fmt::format(
          "the program's map has no degree of freedom {}, the number of a displacement of the mesh", numbers[i]);
      if (mesh.is_of_ixos(node))
        text += fmt::format(
            "; it belongs to node {}, which Mesh/Cell Order 2 (raise_order()) added to the {} nodes of the linear "
            "mesh: "
            "give the map the degrees of freedom of these nodes too, or use Cell Order 1",
            mesh.program_id(node), mesh.linear_nodes);
      throw InputError(text);
    }
  });
}

}  // namespace

DofExchange::DofExchange(const LocalMesh& mesh, const DofSpace& space, const Teuchos::RCP<const Map>& program,
                         const Number& number)
    : space_(space) {
  if (!program->isOneToOne())
    throw InputError("the program's map has a degree of freedom on two ranks; pass a map without ghosts");
  std::vector<GlobalId> numbers;
  together<InputError>(space.comm(), [&] {
    for (int node = 0; node < mesh.owned_nodes; ++node) {
      if (mesh.is_added(static_cast<std::size_t>(node))) continue;
      for (int i = 0; i < mesh.dimension; ++i) {
        places_.push_back(static_cast<std::size_t>(node * mesh.dimension + i));
        numbers.push_back(number(mesh.program_id(static_cast<std::size_t>(node)), i));
      }
    }
    std::vector<GlobalId> sorted = numbers;
    std::sort(sorted.begin(), sorted.end());
    if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
      throw InputError(fmt::format("two displacements have the number {} in the program's map", *twice));
  });
  refuse_missing(*program, numbers, places_, mesh, space.comm());
  aligned_ = Teuchos::rcp(new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                                  Teuchos::ArrayView<const GlobalId>(numbers.data(), static_cast<int>(numbers.size())),
                                  0, space.comm()));
  if (!aligned_->isOneToOne()) throw InputError("displacements of two ranks have the same number in the program's map");
  importer_ = Teuchos::rcp(new Import(program, aligned_));
}

DofExchange::DofExchange(const LocalMesh& mesh, const DofSpace& space, const Teuchos::RCP<const Map>& program)
    : DofExchange(mesh, space, program,
                  [dimension = mesh.dimension](GlobalId node, int component) { return node * dimension + component; }) {
}

DofExchange::~DofExchange() = default;
DofExchange::DofExchange(DofExchange&&) noexcept = default;

void DofExchange::to_model(const MultiVector& program, MultiVector& owned) const {
  MultiVector aligned(aligned_, program.getNumVectors(), false);
  aligned.doImport(program, *importer_, Tpetra::INSERT);
  const auto from = aligned.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto to = owned.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (std::size_t column = 0; column < from.extent(1); ++column)
    for (std::size_t k = 0; k < places_.size(); ++k) to(places_[k], column) = from(k, column);
}

void DofExchange::to_program(const MultiVector& owned, MultiVector& program) const {
  MultiVector aligned(aligned_, owned.getNumVectors(), false);
  {
    const auto from = owned.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto to = aligned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t column = 0; column < from.extent(1); ++column)
      for (std::size_t k = 0; k < places_.size(); ++k) to(k, column) = from(places_[k], column);
  }
  program.doExport(aligned, *importer_, Tpetra::INSERT);
}

void DofExchange::to_model(const Vector& program, std::vector<double>& local) const {
  local.resize(static_cast<std::size_t>(space_.local()), 0.0);
  Vector aligned(aligned_);
  aligned.doImport(program, *importer_, Tpetra::INSERT);
  {
    const auto from = aligned.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t k = 0; k < places_.size(); ++k) local[places_[k]] = from(k, 0);
  }
  space_.update_ghosts(local.data());
}

void DofExchange::to_program(const std::vector<double>& local, Vector& program) const {
  Vector aligned(aligned_);
  {
    const auto to = aligned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t k = 0; k < places_.size(); ++k) to(k, 0) = local[places_[k]];
  }
  program.doExport(aligned, *importer_, Tpetra::INSERT);
}

}  // namespace ixos
