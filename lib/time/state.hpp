/// The state of the model at one time.
#pragma once
#include <vector>

namespace ixos {

/// Local arrays, owned nodes first, then ghosts.
struct State {
  std::vector<double> u;  ///< displacement [L0]
  std::vector<double> v;  ///< velocity [L0/T0]
  std::vector<double> a;  ///< acceleration [L0/T0^2]; of momentum-form schemes only where it was asked for
};

}  // namespace ixos
