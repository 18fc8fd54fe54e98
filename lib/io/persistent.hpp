/// System calls that signals may interrupt.
#pragma once
#include <cerrno>

namespace ixos {

/// Repeats a system call while a signal interrupts it (EINTR). Returns the call's result.
template <class Call>
auto persistent(const Call& call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

}  // namespace ixos
