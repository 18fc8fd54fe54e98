#include "adapt/whole_field.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>

namespace ixos {

std::vector<double> whole_field(const LocalMesh& mesh, const Comm& comm, const std::vector<double>& local,
                                std::size_t count, int nodes) {
  std::vector<double> mine(static_cast<std::size_t>(nodes) * count, 0.0);
  for (int node = 0; node < mesh.nodes(); ++node)
    if (mesh.owns(node))
      std::copy_n(&local[static_cast<std::size_t>(node) * count], count,
                  &mine[static_cast<std::size_t>(mesh.original_ids[static_cast<std::size_t>(node)]) * count]);
  if (comm->getSize() == 1) return mine;
  std::vector<double> whole(mine.size());
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), whole.data());
  return whole;
}

std::vector<double> local_field(const LocalMesh& mesh, const std::vector<double>& whole, std::size_t count) {
  std::vector<double> local(static_cast<std::size_t>(mesh.nodes()) * count);
  for (std::size_t node = 0; node < mesh.original_ids.size(); ++node)
    std::copy_n(&whole[static_cast<std::size_t>(mesh.original_ids[node]) * count], count, &local[node * count]);
  return local;
}

}  // namespace ixos
