#include "parameters/scene_node.hpp"

#include <fmt/format.h>

#include "parameters/parameter_entries.hpp"

namespace ixos {

std::string placed(const std::string& path, const std::string& message) {
  const bool begins = message.rfind(path, 0) == 0;
  const bool ends_there = begins && message.find_first_of("/: ", path.size()) == path.size();
  return path.empty() || ends_there ? message : path + ": " + message;
}

std::vector<double> SceneNode::numbers(const std::string& entry, std::size_t count,
                                       std::vector<double> fallback) const {
  const auto& values = get<Teuchos::Array<double>>(entry);
  if (values.empty()) return fallback;
  if (static_cast<std::size_t>(values.size()) != count)
    throw InputError(fmt::format("{} has {} elements, not {}, which the dimension of the mesh requires", path_of(entry),
                                 values.size(), count));
  return values.toVector();
}

std::vector<SceneNode> SceneNode::sublists() const {
  std::vector<SceneNode> nodes;
  for (const auto& [name, entry] : entries(*list_))
    if (entry.isList()) nodes.push_back(sublist(name));
  return nodes;
}

void SceneNode::refuse(const std::string& entry, const std::string& why) const {
  const std::string place = entry.empty() ? path_ : path_of(entry);
  throw InputError(place.empty() ? why : place + ": " + why);
}

void SceneNode::refuse_value(const std::string& entry, const std::string& value, const std::string& why) const {
  if (const auto slash = entry.find('/'); slash != std::string::npos)
    sublist(entry.substr(0, slash)).refuse_value(entry.substr(slash + 1), value, why);
  if (list_->isSublist(entry)) refuse(entry, why);
  refuse(entry, (value.empty() ? "\"" + text(entry) + "\"" : value) + " " + why);
}

}  // namespace ixos
