#include "material/prony_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "base/text.hpp"

namespace ixos {
namespace {

/// Reads two numbers greater than 0 and nothing else from a text without blanks around it. Returns whether that
/// succeeded.
bool read_branch(std::string text, MaxwellBranch& branch) {
  if (std::count(text.begin(), text.end(), ',') > 1 || text.front() == ',' || text.back() == ',') return false;
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream line(text);
  line.imbue(std::locale::classic());
  std::string rest;
  return line >> branch.time >> branch.modulus && !(line >> rest) && branch.time > 0 && branch.modulus > 0 &&
         std::isfinite(branch.time) && std::isfinite(branch.modulus);
}

}  // namespace

std::vector<MaxwellBranch> read_prony_table(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw InputError(file + ": cannot be read");
  std::vector<MaxwellBranch> branches;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::string text = trimmed(line.substr(0, line.find('#')));
    if (text.empty()) continue;
    MaxwellBranch branch;
    if (!read_branch(text, branch))
      throw InputError(
          fmt::format("{}, line {}: \"{}\" is not a relaxation time and a modulus, two numbers greater "
                      "than 0",
                      file, number, printable(text)));
    branches.push_back(branch);
  }
  if (in.bad()) throw InputError(file + ": cannot be read to its end");
  if (branches.empty()) throw InputError(file + ": has no line with a relaxation time and a modulus");
  return branches;
}

}  // namespace ixos
