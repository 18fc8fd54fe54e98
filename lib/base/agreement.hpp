/// Failures that only some ranks see.
#pragma once
#include <string>

#include "base/tpetra.hpp"

namespace ixos {

/// Throws FileError on all ranks alike where `problem` is not empty on some rank; the message is that of the first such
/// rank. Without it the other ranks would wait in the next collective operation for ever. Collective.
void agree_on_files(const Comm& comm, const std::string& problem);

/// Runs a function that may throw on some ranks, and agrees. Collective.
template <class Function>
void together(const Comm& comm, const Function& function) {
  std::string problem;
  try {
    function();
  } catch (const std::exception& error) {
    problem = error.what();
    if (problem.empty()) problem = "unknown failure";
  }
  agree_on_files(comm, problem);
}

}  // namespace ixos
