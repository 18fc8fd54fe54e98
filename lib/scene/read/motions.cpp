#include "scene/read/motions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.hpp"

namespace ixos {

std::string MotionOptions::along(std::size_t direction) const {
  return direction < translation.size() && translation[direction] != "-" ? translation[direction] : "";
}

std::vector<std::string> MotionOptions::histories() const {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (std::size_t i = 0; i < translation.size(); ++i) add(along(i));
  add(rotation);
  return names;
}

std::string MotionOptions::in_words() const {
  const std::vector<std::string> names = histories();
  return names.empty() ? "held" : fmt::format("driven by history {}", fmt::join(names, ", "));
}

void check_length(const SceneNode& node, const char* entry, std::size_t length, int dimension) {
  if (length != 0 && length != static_cast<std::size_t>(dimension))
    throw InputError(fmt::format("{} has {} elements, not {}, which the dimension of the mesh requires",
                                 node.path_of(entry), length, dimension));
}

RigidMotion rigid_motion(const SceneNode& node, const MotionOptions& options, const Histories& histories,
                         int dimension) {
  check_length(node, "Translation", options.translation.size(), dimension);
  check_length(node, "Point", options.point.size(), dimension);
  RigidMotionOptions motion;
  const auto function = [&](const char* entry, const std::string& name) {
    return at(node.path_of(entry), [&] { return histories.get(name, HistoryUse::Motion); });
  };
  for (std::size_t i = 0; i < options.translation.size(); ++i) {
    const std::string name = options.along(i);
    motion.translation.push_back(name.empty() ? nullptr : function("Translation", name));
  }
  if (!options.rotation.empty()) motion.angle = function("Rotation", options.rotation);
  motion.axis = options.axis;
  motion.point = options.point;
  return at(node.path_of("Axis"), [&] { return RigidMotion(dimension, motion); });
}

}  // namespace ixos
