/// Whether a test runs under AddressSanitizer.
#pragma once
#include <dlfcn.h>

namespace ixos::test {

/// Returns whether AddressSanitizer is linked or preloaded (tests/sanitizers/run.sh): its allocator aborts where others
/// throw, and programs are several times slower.
inline bool sanitized() { return dlsym(RTLD_DEFAULT, "__asan_init") != nullptr; }

}  // namespace ixos::test
