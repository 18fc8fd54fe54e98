/// Failures that only some ranks see.
#pragma once
#include <new>
#include <string>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/tpetra.hpp"

namespace ixos {

/// The first rank's message that is not empty, on all ranks; empty where all are. Collective.
std::string first_problem(const Comm& comm, const std::string& problem);

/// Runs a function that may throw on some ranks, and throws on all ranks alike with the first such rank's message: an
/// InputError or a FileError where that rank threw one, a MemoryError where memory ran out, else `Error`. Without it
/// the other ranks would wait in the next collective operation for ever. Collective.
template <class Error = FileError, class Function>
void together(const Comm& comm, const Function& function) {
  std::string problem;  // its first letter is the kind
  try {
    function();
  } catch (const InputError& error) {
    problem = std::string("I") + error.what();
  } catch (const FileError& error) {
    problem = std::string("F") + error.what();
  } catch (const MemoryError& error) {
    problem = std::string("M") + error.what();
  } catch (const std::bad_alloc&) {
    problem = "M" + out_of_memory();
  } catch (const std::exception& error) {
    problem = std::string(" ") + error.what();
  }
  problem = first_problem(comm, problem);
  if (problem.empty()) return;
  const std::string message = problem.size() > 1 ? problem.substr(1) : "unknown failure";
  if (problem[0] == 'I') throw InputError(message);
  if (problem[0] == 'F') throw FileError(message);
  if (problem[0] == 'M') throw MemoryError(message);
  throw Error(message);
}

/// The same of a function that only the first rank runs. Collective.
template <class Function>
void on_first_rank(const Comm& comm, const Function& function) {
  together(comm, [&] {
    if (comm->getRank() == 0) function();
  });
}

}  // namespace ixos
