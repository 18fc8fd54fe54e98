#include "discretization/discretization.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace ixos {

Discretization::Discretization(LocalMesh mesh, const Comm& comm, GlobalUnknowns globals)
    : mesh_(std::move(mesh)), space_(mesh_, comm, std::move(globals)), pattern_(mesh_) {}

void Discretization::check_local(const std::vector<std::vector<int>>& stencils) const {
  for (const std::vector<int>& stencil : stencils)
    for (const int node : stencil)
      if (node < 0 || node >= mesh_.nodes())
        throw std::out_of_range("node " + std::to_string(node) + " of a stencil is not local to the rank");
}

void Discretization::renew_pattern() {
  std::vector<std::vector<int>> all = stencils_;
  all.insert(all.end(), stencils_for_now_.begin(), stencils_for_now_.end());
  pattern_ = Pattern(mesh_, all);
  ++version_;
}

void Discretization::couple(const std::vector<std::vector<int>>& stencils) {
  check_local(stencils);
  stencils_.insert(stencils_.end(), stencils.begin(), stencils.end());
  renew_pattern();
}

void Discretization::couple_for_now(std::vector<std::vector<int>> stencils) {
  check_local(stencils);
  stencils_for_now_ = std::move(stencils);
  renew_pattern();
}

}  // namespace ixos
