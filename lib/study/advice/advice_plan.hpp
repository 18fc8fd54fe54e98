/// The choice among settings by errors and costs.
#pragma once
#include <vector>

#include "study/advice/advice_costs.hpp"
#include "study/advice/advice_errors.hpp"

namespace ixos {

struct AdviceCandidate {
  AdvicePoint point;
  AdviceEstimate estimate;
  double error = 0;    ///< the largest of the quantities'
  double seconds = 0;  ///< of processor time, to expect
};

/// Returns all points whose errors are known, the cheapest first. `beyond`: levels that a point may be finer than the
/// finest one tested.
std::vector<AdviceCandidate> candidates(const AdviceDirections& directions, const AdviceErrors& errors,
                                        const AdviceCosts& costs, std::size_t beyond);

/// Returns the first of candidates within the tolerance; null if there is none.
const AdviceCandidate* cheapest_within(const std::vector<AdviceCandidate>& all, double tolerance);

/// Returns the candidate of the smallest error, the cheapest of equal ones; null if there is none.
const AdviceCandidate* most_accurate(const std::vector<AdviceCandidate>& all);

/// Returns the candidates that no other beats in both cost and error, the cheapest first.
std::vector<AdviceCandidate> best_trades(const std::vector<AdviceCandidate>& all);

}  // namespace ixos
