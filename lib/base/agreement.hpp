/// Failures that only some ranks see.
#pragma once
#include <string>

#include "base/error.hpp"
#include "base/tpetra.hpp"

namespace ixos {

/// The first rank's message that is not empty, on all ranks; empty where all are. Collective.
std::string first_problem(const Comm& comm, const std::string& problem);

/// Runs a function that may throw on some ranks, and throws `Error` on all ranks alike with the first such rank's
/// message. Without it the other ranks would wait in the next collective operation for ever. Collective.
template <class Error = FileError, class Function>
void together(const Comm& comm, const Function& function) {
  std::string problem;
  try {
    function();
  } catch (const std::exception& error) {
    problem = error.what();
    if (problem.empty()) problem = "unknown failure";
  }
  problem = first_problem(comm, problem);
  if (!problem.empty()) throw Error(problem);
}

}  // namespace ixos
