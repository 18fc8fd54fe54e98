/// The sum of the second derivatives of gaps over points and times.
#pragma once
#include <vector>

#include "base/pack.hpp"
#include "geometry/pair_gap.hpp"

namespace ixos {

/// Sums PairGap's matrices over the points of a secondary patch with closest points on one primary patch. The weights
/// of the point's own patch are the same for all times, so that they multiply the sum over the times: a matrix of the
/// projection's patch is all that each time takes.
template <std::size_t D>
class PairSums {
 public:
  /// Begins a sum for patches of as many nodes.
  void begin(std::size_t secondary, std::size_t primary);
  /// Adds the matrix along * grad g grad g^T + across * d2g of a time of the present point.
  void add(const PairGap<D>& gap, double along, double across);
  /// Ends the point. `weights`: its own, of the nodes of its patch.
  void end_point(const typename SurfacePatch<D>::Weights& weights);
  /// Sets the matrix to the sum. Its rows and columns: the secondary nodes, then the primary ones, whose rows are 0
  /// unless they react.
  void write(std::vector<double>& matrix, bool reacts = true) const;

 private:
  /// Blocks of D x D numbers for the nodes along a row of packs.
  static constexpr std::size_t square = D * D;
  void load(const PairGap<D>& gap);

  std::size_t secondary_ = 0, primary_ = 0;              ///< nodes
  std::size_t secondary_packs_ = 0, primary_packs_ = 0;  ///< of one number of each node
  bool open_ = false;                                    ///< the present point has been added to
  std::array<double, square> own_{};                     ///< of the present point: M_0i0j, summed
  std::vector<Pack> mixed_;                              ///< of the present point, M_0ilj w^l_b: [i D + j][b]
  std::vector<Pack> weights_;                            ///< [l][b] of a closest point, or the point's own
  std::vector<Pack> among_secondary_, across_;           ///< [a][i D + j][b]
  std::vector<Pack> among_primary_;                      ///< the same, from the pack of a on
};

extern template class PairSums<2>;
extern template class PairSums<3>;

}  // namespace ixos
