/// The recommendation that a study's results lead to.
#pragma once
#include <string>
#include <vector>

#include "study/compare/study.hpp"
#include "study/compare/study_errors.hpp"
#include "study/compare/study_result.hpp"

namespace ixos {

/// Returns the runs that no other beats in both cost and error, the cheapest first.
std::vector<const StudyResult*> pareto(const std::vector<StudyResult>& results, const std::string& cost,
                                       const std::string& measure);

struct Recommendation {
  const StudyResult* run = nullptr;  ///< null if no run is good enough
  std::string sentence;
};

/// Returns the cheapest run within the tolerance; without a tolerance the most accurate run within the budget.
///
/// The error of a run counts as at least that of every finer run on its line, which may be larger if the error changes
/// its sign: such a run is accurate by coincidence, and the sentence names it. A line holds the runs that differ only
/// in the connecting axis, if the labels of that are numbers that rise or fall; its more expensive end is the finer
/// one. A run is within the tolerance if its error and that of the reference together are. The sentence tells the error
/// of the reference, whether that is more than a third of the tolerance, and whether it contains an error of the mesh.
/// A peak or a work within the tolerance is doubted if the force over time is not.
Recommendation recommend(const Study& study, const std::vector<StudyResult>& results,
                         const ReferenceQuality& reference);

}  // namespace ixos
