/// The state of the model at one time.
#pragma once
#include <vector>

#include "fem/row_on_states.hpp"

namespace ixos {

/// u, v, a are local arrays, owned nodes first, then ghosts. Loads and reactions are owned arrays, empty if the model
/// has no loads (no constraints); those of momentum-form schemes are means over the step that led here.
struct State {
  std::vector<double> u;           ///< displacement [L0]
  std::vector<double> v;           ///< velocity [L0/T0]
  std::vector<double> a;           ///< acceleration [L0/T0^2]; of momentum-form schemes only if it was asked for
  std::vector<double> load{};      ///< external forces [E0 L0^(D-1)]
  std::vector<double> reaction{};  ///< of constrained degrees of freedom, inertia and damping included; zero elsewhere
};

/// Returns the first `count` states as rows and terms see them.
inline std::vector<KnownState> known_states(const std::vector<State>& states, std::size_t count) {
  std::vector<KnownState> known(count);
  for (std::size_t i = 0; i < count; ++i)
    known[i] = {states[i].u.data(), states[i].v.data(), states[i].a.empty() ? nullptr : states[i].a.data()};
  return known;
}

}  // namespace ixos
