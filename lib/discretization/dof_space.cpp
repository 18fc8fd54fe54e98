#include "discretization/dof_space.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <utility>

namespace ixos {
namespace {

Teuchos::RCP<const Map> dof_map(const LocalMesh& mesh, int nodes, long long global, const Comm& comm) {
  std::vector<GlobalId> ids;
  ids.reserve(static_cast<std::size_t>(nodes) * static_cast<std::size_t>(mesh.dimension));
  for (int node = 0; node < nodes; ++node)
    for (int d = 0; d < mesh.dimension; ++d)
      ids.push_back(mesh.global_ids[static_cast<std::size_t>(node)] * mesh.dimension + d);
  return Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(global),
                              Teuchos::ArrayView<const GlobalId>(ids.data(), static_cast<int>(ids.size())), 0, comm));
}

double reduce(double value, Teuchos::EReductionType type, const Comm& comm) {
  if (comm->getSize() == 1) return value;
  double result = value;
  Teuchos::reduceAll<int, double>(*comm, type, 1, &value, &result);
  return result;
}

}  // namespace

DofSpace::DofSpace(const LocalMesh& mesh, const Comm& comm, GlobalUnknowns globals)
    : dimension_(mesh.dimension),
      owned_(mesh.owned_nodes * mesh.dimension),
      local_(mesh.nodes() * mesh.dimension + globals.numbers),
      global_(mesh.global_nodes * mesh.dimension),
      globals_(std::move(globals)),
      ties_(mesh.ties),
      comm_(comm),
      owned_map_(Teuchos::rcp(
          new Map(static_cast<Tpetra::global_size_t>(global_), static_cast<std::size_t>(owned_), 0, comm))),
      local_map_(comm->getSize() == 1
                     ? owned_map_
                     : dof_map(mesh, mesh.nodes() - mesh.ties.size(),
                               static_cast<long long>(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid()), comm)),
      unknown_map_(owned_map_) {
  if (has_globals()) {
    const std::size_t more = comm->getRank() == 0 ? globals_.free.size() : 0;
    unknown_map_ = Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(global_) + globals_.free.size(),
                                        static_cast<std::size_t>(owned_) + more, 0, comm));
  }
  if (comm->getSize() == 1) return;
  importer_ = Teuchos::rcp(new Import(owned_map_, local_map_));
  buffer_ = Teuchos::rcp(new Vector(local_map_));
}

DofSpace::~DofSpace() = default;

void DofSpace::import(const Vector& owned, double* local) const {
  if (!has_globals() || owned.getGlobalLength() == static_cast<Tpetra::global_size_t>(global_))
    return import_nodes(owned, local);
  std::vector<double> values(globals_.free.size());
  if (buffer_.is_null())
    import_nodes(owned, local);  // without a view of the nodes, which costs more than the copy
  else
    import_nodes(*owned.offsetView(owned_map_, 0), local);
  if (comm_->getRank() == 0) {
    const auto view = owned.getLocalViewHost(Tpetra::Access::ReadOnly);
    std::copy_n(view.data() + owned_, values.size(), values.begin());
  }
  if (comm_->getSize() > 1) Teuchos::broadcast(*comm_, 0, static_cast<int>(values.size()), values.data());
  for (std::size_t k = 0; k < values.size(); ++k) local[place_of_free(k)] = values[k];
}

void DofSpace::import_nodes(const Vector& owned, double* local) const {
  if (buffer_.is_null()) {
    const auto view = owned.getLocalViewHost(Tpetra::Access::ReadOnly);
    std::copy_n(view.data(), owned_, local);
    interpolate_tied(local);
    return;
  }
  buffer_->doImport(owned, *importer_, Tpetra::INSERT);
  const auto view = buffer_->getLocalViewHost(Tpetra::Access::ReadOnly);
  std::copy_n(view.data(), view.extent(0), local);
  interpolate_tied(local);
}

void DofSpace::take(const double* local, Vector& owned) const {
  const auto view = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy_n(local, owned_, view.data());
  for (std::size_t i = static_cast<std::size_t>(owned_); i < view.extent(0); ++i)
    view(i, 0) = local[place_of_free(i - static_cast<std::size_t>(owned_))];
}

void DofSpace::update_ghosts(double* local) const {
  if (buffer_.is_null()) return interpolate_tied(local);
  Vector owned(owned_map_);
  {
    const auto view = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    std::copy_n(local, owned_, view.data());
  }
  import(owned, local);
}

void DofSpace::sum(double* values, int count) const {
  if (comm_->getSize() == 1) return;
  const std::vector<double> mine(values, values + count);
  Teuchos::reduceAll<int, double>(*comm_, Teuchos::REDUCE_SUM, count, mine.data(), values);
}

double DofSpace::minimum(double value) const { return reduce(value, Teuchos::REDUCE_MIN, comm_); }

double DofSpace::maximum(double value) const { return reduce(value, Teuchos::REDUCE_MAX, comm_); }

}  // namespace ixos
