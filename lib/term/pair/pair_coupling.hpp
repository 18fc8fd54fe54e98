/// The nodes of two surfaces that the matrix of their interaction couples.
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "base/record.hpp"
#include "term/pair/pair_points.hpp"

namespace ixos {

/// The pairs of a secondary and a primary patch that were within reach, and a skin beyond it, at the last search. A new
/// search is due when the nodes have moved so far that others can be within reach. Overlaps count as deep as the law
/// acts. It changes the pairs only if one within reach is missing. The matrix leaves out the blocks of patches that are
/// farther apart. They act on each other all the same, with less than 1e-3 of the largest stiffness beyond the
/// equilibrium gap (reach_of_stiffness()). It leaves them out as a whole: the columns of each block have no sum, so
/// that a step of Newton's method changes the linear momentum by no more than rounding, whatever the matrix lacks.
template <std::size_t D>
class PairCoupling {
 public:
  /// The points must outlive it.
  explicit PairCoupling(const PairPoints<D>& points);

  /// Searches at these places, if that is due. Returns whether the pairs have changed. The first call after a record
  /// was loaded does not search: what else the record has belongs to its pairs.
  bool update(const typename PairPoints<D>::Places& places);
  /// Couples, from the next update on, the nodes of all primary patches of a secondary patch with each other, too: a
  /// discrete gradient has closest points at the mean and at the end of a step.
  void join() { join_due_ = !joined_; }
  /// Returns the local nodes of each pair, or of each secondary patch and its primary ones.
  std::vector<std::vector<int>> stencils() const;
  /// Returns whether all nodes of the block are coupled, alike on all ranks.
  bool covers(const PairBlock& block) const;
  /// Makes a search due, whose pairs do not depend on those of earlier ones.
  void begin_anew() {
    last_.clear();
    loaded_ = false;
  }
  /// Transfers the pairs and the places of the last search. Loading on another partition begins anew.
  void transfer(Record& record);
  double reach() const { return reach_; }
  long searches() const { return searches_; }

 private:
  using Pair = std::pair<int, int>;
  std::vector<Pair> pairs_within(const typename PairPoints<D>::Places& places, double range) const;
  double motion(const typename PairPoints<D>::Places& places) const;

  const PairPoints<D>& points_;
  double reach_, skin_;
  PairOverlap<D> overlap_;
  std::vector<Pair> pairs_;   ///< ascending
  std::vector<double> last_;  ///< places of the last search; empty if there was none
  long searches_ = 0;
  bool joined_ = false;
  bool join_due_ = false;  ///< at the next update
  bool anew_ = false;      ///< the stencils are others than at the last update
  bool loaded_ = false;    ///< since the last update, from a record
};

/// Returns the gap beyond which the law's stiffness stays below 1e-3 of the largest one that it has beyond its
/// equilibrium gap; a hundred times the equilibrium gap at most [L0].
double reach_of_stiffness(const GapLaw& law);

extern template class PairCoupling<2>;
extern template class PairCoupling<3>;

}  // namespace ixos
