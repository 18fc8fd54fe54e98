/// A run of a scene, and the messages on it.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <string>
#include <vector>

#include "base/warning.hpp"
#include "ixos/arguments.hpp"
#include "run/run.hpp"

namespace ixos {

/// Returns whether this rank tells the user more than errors.
bool speaks(const Arguments& arguments, const Comm& comm);

/// Prints one line on the simulation, and the notes on its mesh.
void introduce(const Simulation& simulation);

/// Prints the sizes of the mesh's sets, and the hints on the scene.
void tell_sets_and_hints(const Simulation& simulation);

void warn(const std::vector<Warning>& warnings);

/// Runs a simulation into the results folder and shows its progress. `tells`: whether to print its lines and warnings.
/// `observe`: see RunOptions. Collective.
RunResult carry_out(Simulation& simulation, const Arguments& arguments, bool tells = true,
                    const std::function<std::string(const Progress&)>& observe = {});

/// Tells why a run without results failed, and what may help, on the first rank. Returns the exit status.
int tell_failure(const RunResult& result, const Comm& comm);

/// Tells how the run ended, on the first rank. Returns the exit status.
int report_end(const RunResult& result, const Arguments& arguments, const Comm& comm);

}  // namespace ixos
