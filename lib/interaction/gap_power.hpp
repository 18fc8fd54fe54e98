/// Powers of the gap.
#pragma once

namespace ixos {

/// A part of a law's traction T(r): factor r^-exponent [E0], r in L0, a whole number of at least 2.
struct GapPower {
  double factor, exponent;
};

}  // namespace ixos
