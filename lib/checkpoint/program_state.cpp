#include "checkpoint/program_state.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

namespace ixos {
namespace {

using Names = std::set<std::string>;

Names names_of(const std::vector<ProgramState>& states) {
  Names names;
  for (const ProgramState& state : states)
    if (state.name.empty() || state.name.find_first_of("/\n") != std::string::npos || !names.insert(state.name).second)
      throw std::logic_error(fmt::format("\"{}\" is no name of a state, or the name of another one", state.name));
  return names;
}

/// Returns the names of the states that a record has.
Names names_in(Record& record) {
  if (!record.has_section("program")) return {};
  const Record::Section section(record, "program");
  std::string text;
  record.text("states", text);
  Names names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) names.insert(line);
  return names;
}

void check(const Names& wanted, const Names& there) {
  const auto quoted = [](const Names& names) { return fmt::format("\"{}\"", fmt::join(names, "\", \"")); };
  Names missing, unread;
  std::set_difference(wanted.begin(), wanted.end(), there.begin(), there.end(), std::inserter(missing, missing.end()));
  std::set_difference(there.begin(), there.end(), wanted.begin(), wanted.end(), std::inserter(unread, unread.end()));
  if (!missing.empty())
    throw InputError(fmt::format("lacks {}, the state of this program; {}", quoted(missing),
                                 there.empty() ? "no program's state is in it" : "it has " + quoted(there)));
  if (!unread.empty())
    throw InputError(fmt::format("holds {}, the state of a program around Ixos; only that program can resume from it",
                                 quoted(unread)));
}

}  // namespace

void transfer(Record& record, const std::vector<ProgramState>& states) {
  const Names names = names_of(states);
  if (record.loading()) check(names, names_in(record));
  if (states.empty()) return;
  const Record::Section section(record, "program");
  std::string text = fmt::format("{}", fmt::join(names, "\n"));
  record.text("states", text);
  for (const ProgramState& state : states) {
    const Record::Section own(record, state.name);
    try {
      state.transfer(record);
    } catch (const InputError& error) {
      throw InputError(fmt::format("\"{}\", a state of this program: {}", state.name, error.what()));
    }
  }
}

}  // namespace ixos
