/// The integrals of a mortar tie.
#pragma once
#include <map>
#include <vector>

#include "mesh/mortar/facing_parts.hpp"

namespace ixos {

/// The integrals that tie the nodes of one surface to those of another: D_i = int N_i and M_ik = int psi_i N_k over the
/// former, with psi dual to N, see tie_surfaces().
class MortarSums {
 public:
  explicit MortarSums(bool axisymmetric) : axisymmetric_(axisymmetric) {}

  /// Adds the integrals over a side, the sum of those over its parts. The side's own dual functions are psi = diag(int
  /// N) (int N N^T)^-1 N. Returns false if a point of a part is not on both sides: one of them is bent too much.
  bool add(const Facet& secondary, const std::vector<FacingPart>& parts);

  /// Returns D by node, and M by node and primary node [L0, L0^2, of a body of revolution L0^2 without 2 pi].
  const std::map<int, double>& areas() const { return areas_; }
  const std::map<int, std::map<int, double>>& products() const { return products_; }

 private:
  bool axisymmetric_;
  std::map<int, double> areas_;
  std::map<int, std::map<int, double>> products_;
};

}  // namespace ixos
