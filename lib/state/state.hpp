/// The state of the model at one time.
#pragma once
#include <vector>

#include "rule/row_on_states.hpp"
#include "state/place.hpp"

namespace ixos {

/// A value: it can be copied, compared and kept, and an integrator continues from any copy. u, v, a are local arrays,
/// owned nodes first, then ghosts. Loads and reactions are owned arrays, empty if the model has no loads (no
/// constraints); those of momentum-form schemes are means over the step that led here.
struct State {
  std::vector<double> u;                  ///< displacement [L0]
  std::vector<double> v;                  ///< velocity [L0/T0]
  std::vector<double> a;                  ///< acceleration [L0/T0^2]; of momentum-form schemes only if it was asked for
  std::vector<double> load{};             ///< external forces [E0 L0^(D-1)]
  std::vector<double> load_on_globals{};  ///< those on what is no node's: on the first rank
  std::vector<double> reaction{};  ///< of constrained degrees of freedom, inertia and damping included; zero elsewhere
  double time = 0;                 ///< [T0]
  TermHistories histories{};       ///< what terms keep; empty at the end of a stage within a step

  bool operator==(const State& other) const {
    return u == other.u && v == other.v && a == other.a && load == other.load &&
           load_on_globals == other.load_on_globals && reaction == other.reaction && time == other.time &&
           histories == other.histories;
  }
  bool operator!=(const State& other) const { return !(*this == other); }

  Place place() const { return {u.data(), time, &histories, nullptr, v.data()}; }
};

/// Returns the first `count` states as rows and terms see them.
inline std::vector<KnownState> known_states(const std::vector<State>& states, std::size_t count) {
  std::vector<KnownState> known(count);
  for (std::size_t i = 0; i < count; ++i)
    known[i] = {states[i].u.data(), states[i].v.data(), states[i].a.empty() ? nullptr : states[i].a.data(),
                states[i].time};
  return known;
}

}  // namespace ixos
