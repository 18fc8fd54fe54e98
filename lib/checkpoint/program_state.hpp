/// The state of the program around Ixos, in the same checkpoint.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/record.hpp"

namespace ixos {

/// A part of a checkpoint that belongs to the caller.
struct ProgramState {
  std::string name;  ///< neither empty nor with a slash or line break; each name once
  /// Names the values (see Record), for writing and reading. When a checkpoint is written it is called twice, first to
  /// learn the size. On another number of ranks, Record::share() and array() cannot be read.
  std::function<void(Record&)> transfer;
};

/// Writes or reads the states in a section "program"; writes nothing if there are none. Loading throws InputError,
/// naming the state, before it reads any, unless the record has exactly these states; and if a state's own function
/// throws one. Throws std::logic_error if a name is not allowed. Collective.
void transfer(Record& record, const std::vector<ProgramState>& states);

}  // namespace ixos
