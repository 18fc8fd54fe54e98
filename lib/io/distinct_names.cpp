#include "io/distinct_names.hpp"

#include <cctype>
#include <set>
#include <string>

namespace ixos {
namespace {

/// Returns the name as IOSS compares it.
std::string key(std::string name) {
  for (char& c : name) c = c == ' ' || c == '.' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

std::string unused(const std::string& name, const std::set<std::string>& taken) {
  std::string result = name;
  for (int k = 2; taken.count(key(result)) > 0; ++k) result = name + "_" + std::to_string(k);
  return result;
}

}  // namespace

void make_names_distinct(Mesh& mesh) {
  std::set<std::string> taken, kept;
  const auto collect = [&](const auto& parts) {
    for (const auto& part : parts) taken.insert(key(part.name));
  };
  collect(mesh.blocks);
  collect(mesh.side_sets);
  collect(mesh.node_sets);
  const auto rename = [&](auto& parts, const char* suffix) {
    for (auto& part : parts) {
      if (kept.insert(key(part.name)).second) continue;
      part.name = unused(part.name + suffix, taken);
      taken.insert(key(part.name));
    }
  };
  rename(mesh.blocks, "");
  rename(mesh.side_sets, "_sides");
  rename(mesh.node_sets, "_nodes");
}

}  // namespace ixos
