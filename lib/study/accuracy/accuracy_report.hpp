/// The answer of runs to an accuracy, as text and in summary.json.
#pragma once
#include <string>

#include "study/accuracy/accuracy.hpp"

namespace ixos {

/// Returns one line on a run: its limits, cost and values.
std::string run_text(const AccuracyQuestion& question, const AccuracyRun& run, std::size_t number);

/// Returns the answer as lines: whether the accuracy is kept, the error of each quantity, or what limits it.
std::string accuracy_text(const AccuracyQuestion& question, const AccuracyResult& result);

/// Adds the object "accuracy" to summary.json of the last run's folder: quantities, errors, settings and runs. Throws
/// FileError.
void add_accuracy(const AccuracyQuestion& question, const AccuracyResult& result, const std::string& folder);

/// Returns whether a folder holds results of a complete scene with the object "accuracy", whatever their steps. The
/// command replaces them without --overwrite.
bool holds_accuracy(const std::string& folder, const Teuchos::ParameterList& scene);

}  // namespace ixos
