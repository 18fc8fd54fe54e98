#include "base/simd_width.hpp"

#include "base/pack.hpp"

namespace ixos {

int simd_width() { return pack_width; }

}  // namespace ixos
