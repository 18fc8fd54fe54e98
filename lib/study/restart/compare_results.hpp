/// Comparison of the results of two runs that should be the same to the bit.
#pragma once
#include <limits>
#include <string>

namespace ixos {

/// Returns the first difference of two tables history.csv up to a step, as "step 7, column total_energy: 0.1 and 0.2";
/// empty if there is none. Compares cells as text, but for the column wall_seconds, a clock. Ignores rows of later
/// steps. Throws FileError if a file cannot be read.
std::string history_difference(const std::string& expected, const std::string& found,
                               long last_step = std::numeric_limits<long>::max());

/// Returns the first difference of two files summary.json, as "steps: 40 and 41"; empty if there is none. Ignores what
/// no two runs share, or what counts restarts: clocks, memory, `restarts`, and the name of the newest checkpoint.
/// Throws FileError.
std::string summary_difference(const std::string& expected, const std::string& found);

/// Returns the first difference of the folders of two complete runs: history.csv, summary.json, and every byte of the
/// files fields.e; empty if there is none. Throws FileError.
std::string results_difference(const std::string& expected, const std::string& found);

}  // namespace ixos
