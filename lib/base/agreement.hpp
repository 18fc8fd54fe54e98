/// Failures that only some ranks see.
#pragma once
#include <new>
#include <string>

#include "base/error.hpp"
#include "base/tpetra.hpp"

namespace ixos {

/// Returns, on all ranks, the first message in the order of ranks that is not empty. Returns an empty string if all are
/// empty. Collective.
std::string first_problem(const Comm& comm, const std::string& problem);

/// Returns the first rank's text on all ranks. Collective.
std::string from_first_rank(const Comm& comm, const std::string& text);

/// Runs a function that may throw on some ranks. If it throws on any, all ranks throw with the message of the first
/// rank that failed: an InputError or a FileError if that rank threw one, otherwise `Error`. Without this, the other
/// ranks would wait for ever in the next collective operation. A std::bad_alloc passes through on its rank at once: the
/// function may be collective, and the others wait inside it; the program has to end the job. Collective.
template <class Error = FileError, class Function>
void together(const Comm& comm, const Function& function) {
  std::string problem;  // its first letter is the kind
  try {
    function();
  } catch (const InputError& error) {
    problem = std::string("I") + error.what();
  } catch (const FileError& error) {
    problem = std::string("F") + error.what();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    problem = std::string(" ") + error.what();
  }
  problem = first_problem(comm, problem);
  if (problem.empty()) return;
  const std::string message = problem.size() > 1 ? problem.substr(1) : "unknown failure";
  if (problem[0] == 'I') throw InputError(message);
  if (problem[0] == 'F') throw FileError(message);
  throw Error(message);
}

/// Runs a function on the first rank only. If it throws, all ranks throw, as together() does. Collective.
template <class Function>
void on_first_rank(const Comm& comm, const Function& function) {
  together(comm, [&] {
    if (comm->getRank() == 0) function();
  });
}

}  // namespace ixos
