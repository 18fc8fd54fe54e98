/// Checkpoints of programs that take the steps themselves; run() writes and reads its own.
#pragma once
#include <string>
#include <vector>

#include "checkpoint/program_state.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// Writes the integrator's state, and the program's, to a file: sealed, and moved into place when it is whole. Throws
/// FileError; then the previous file remains. Collective.
void write_checkpoint(const std::string& path, Simulation& simulation, const std::vector<ProgramState>& states = {});

/// Reads it back. The steps that follow have the same bits if the scene, the solvers and the ranks are the same; what
/// may change is what a run may change at a restart. Returns sentences on changes, for the user. Throws InputError with
/// the file's name, see Restart, and unless the file has exactly these states of the program. Collective.
std::vector<std::string> read_checkpoint(const std::string& path, Simulation& simulation,
                                         const std::vector<ProgramState>& states = {});

/// Write and read an integrator of a model without a scene. The file names the scheme and has the coordinates of the
/// nodes: reading throws InputError if either differs. It cannot know what else the program built otherwise than
/// before.
void write_checkpoint(const std::string& path, Integrator& integrator, const std::vector<ProgramState>& states = {});
std::vector<std::string> read_checkpoint(const std::string& path, Integrator& integrator,
                                         const std::vector<ProgramState>& states = {});

}  // namespace ixos
