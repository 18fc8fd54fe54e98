/// The SIMD width of the library that runs.
#pragma once

namespace ixos {

/// Returns how many doubles the library's kernels process at once. An installation may have builds of the library for
/// several instruction sets, of which the loader chooses one at start: `pack_width` of a program is its own.
int simd_width();

}  // namespace ixos
