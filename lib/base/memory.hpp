/// The message for a run that ends because memory ran out.
#pragma once
#include <cstddef>
#include <string>

namespace ixos {

/// Notes a failed allocation with the current phase of the run (see phase_timer.hpp). A program calls it from its
/// `operator new`; a solver calls it if a library reports that memory ran out. 0 bytes: not known.
void note_failed_allocation(std::size_t bytes) noexcept;

/// Returns whether any failed allocation was noted. A library may have turned it into an error of another kind.
bool memory_ran_out() noexcept;

/// Returns "out of memory: 1.5 GiB were asked for, phase: factorization", as far as the last failure is known.
std::string out_of_memory();

}  // namespace ixos
