#include "discretization/discretization.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace ixos {

Discretization::Discretization(LocalMesh mesh, const Comm& comm)
    : mesh_(std::move(mesh)), space_(mesh_, comm), pattern_(mesh_) {}

void Discretization::couple(const std::vector<std::vector<int>>& stencils) {
  for (const std::vector<int>& stencil : stencils)
    for (const int node : stencil)
      if (node < 0 || node >= mesh_.nodes())
        throw std::out_of_range("node " + std::to_string(node) + " of a stencil is not local to the rank");
  stencils_.insert(stencils_.end(), stencils.begin(), stencils.end());
  pattern_ = Pattern(mesh_, stencils_);
  ++version_;
}

}  // namespace ixos
