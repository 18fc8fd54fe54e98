// In the place of lib/io/guarded.cpp: what a child process would try is tried here, where the fuzzer and the sanitizers
// see it.
#include "io/guarded.hpp"

namespace ixos {

std::string trial(const std::function<void()>& function, std::uint64_t /*bytes*/, unsigned /*seconds*/) {
  function();
  return "";
}

void try_reading(const std::string& /*path*/, const std::function<void()>& function) { function(); }

}  // namespace ixos
