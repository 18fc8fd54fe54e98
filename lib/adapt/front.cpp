#include "adapt/front.hpp"

#include <algorithm>
#include <cmath>

#include "adapt/field_at.hpp"
#include "interaction/gap_law.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

double strength(const GapLaw& law) {
  const double attraction = -static_cast<double>(law.traction(Pack(law.adhesion_gap()))[0]);
  return attraction > 0 ? attraction : 0;
}

double traction_change(const GapLaw& law, double least, double largest) {
  const auto traction = [&](double gap) { return static_cast<double>(law.traction(Pack(gap))[0]); };
  const double peak = law.adhesion_gap(), strength = ixos::strength(law);
  if (strength == 0) return 0;
  const double lowest = law.domain() == GapDomain::All ? least : std::max(least, 1e-3 * law.equilibrium_gap());
  const auto attraction = [&](double gap) { return std::max(-traction(std::max(gap, lowest)), -strength); };
  double low = attraction(least), high = low;
  for (const double gap : {largest, std::clamp(peak, least, largest)}) {
    low = std::min(low, attraction(gap));
    high = std::max(high, attraction(gap));
  }
  return (high - low) / strength;
}

void Front::Range::add(double gap) {
  least = std::min(least, gap);
  largest = std::max(largest, gap);
}

Front::Front(const SplitMesh& mesh, const std::string& side_set, std::shared_ptr<const GapLaw> law,
             std::vector<double> gaps)
    : mesh_(mesh), law_(std::move(law)), gaps_(std::move(gaps)) {
  for (double& gap : gaps_)
    if (std::isnan(gap)) gap = 0;
  for (const Side& side : side_set_named(mesh.mesh(), side_set).sides) add(side);
}

/// Adds the gaps of a side to its leaf and to all cells around it.
void Front::add(const Side& side) {
  const SplitTree& tree = mesh_.tree();
  const std::vector<int> nodes = nodes_of_side(mesh_.mesh(), side);
  const TreeCell& leaf = tree.cell(mesh_.leaf_of({side.block, side.cell}));
  const int face = mesh_.face_of({side.block, side.cell}, side.side);
  if (face >= leaf.faces() || !leaf.touches(face)) return;
  for (int k = tree.root(leaf.block, leaf.root);;) {
    Range& range = ranges_[{k, face}];
    for (const int node : nodes) range.add(gaps_[at(node)]);
    if (tree.is_leaf(k)) return leaves_.push_back(k);
    const int child = tree.cell(k).first_child;
    k = tree.cell(child).contains(leaf) ? child : child + 1;
  }
}

Front::Range Front::range(const TreeCell& cell, int face) const {
  const int around = mesh_.tree().around(cell);
  const auto found = ranges_.find({around, face});
  if (found == ranges_.end()) return {};
  const TreeCell& old = mesh_.tree().cell(around);
  const bool is_part = !old.is_split() && !cell.is_same_part(old);
  if (!is_part) return found->second;
  Range range;
  for (const int corner : cell.corners_on(face)) {
    double gap = 0;
    evaluate(mesh_, gaps_, 1, {cell.block, cell.root, cell.place(corner)}, &gap);
    range.add(gap);
  }
  return range;
}

double Front::change(const TreeCell& cell) const {
  double change = 0;
  if (cell.shape == TreeShape::Whole) return 0;  // it cannot be split
  for (int face = 0; face < cell.faces(); ++face) {
    if (!cell.touches(face)) continue;
    const Range own = range(cell, face);
    if (own.least <= own.largest) change = std::max(change, traction_change(*law_, own.least, own.largest));
  }
  return change;
}

}  // namespace ixos
