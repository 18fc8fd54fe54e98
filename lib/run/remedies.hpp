/// Other settings for a run whose step failed.
#pragma once
#include <string>
#include <vector>

#include "scene/simulation.hpp"

namespace ixos {

/// A setting with which a failed run may go on from its last state.
struct Remedy {
  std::string what;        ///< in words: "shorter steps"
  std::string assignment;  ///< as of --set: "Time Integrator/Time Step Control/Maximum Cuts=10"
};

/// Returns what differs from the present settings and may help a step that failed, the most likely one first.
/// `ran_out`: because Newton's iterations were used up. Collective.
std::vector<Remedy> remedies(const Simulation& simulation, bool ran_out);

}  // namespace ixos
