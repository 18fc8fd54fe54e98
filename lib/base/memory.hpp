/// What is said when memory runs out.
#pragma once
#include <cstddef>
#include <string>

namespace ixos {

/// Notes an allocation that fails, with the phase of the run in which it was asked for (see phase_timer.hpp). A program
/// calls it from its `operator new`, a solver where a library reports want of memory; 0 bytes: not known.
void note_failed_allocation(std::size_t bytes) noexcept;

/// Returns "out of memory: 1.5 GiB were asked for, phase: factorization", with what is known of the last failure.
std::string out_of_memory();

}  // namespace ixos
