#include "study/advice/advice_point.hpp"

#include <cctype>

namespace ixos {

AdvicePoint scene_point(const AdviceDirections& directions) {
  AdvicePoint point;
  for (const AdviceDirection& direction : directions.all) point.push_back({0, direction.scene_level});
  return point;
}

Assignments settings_of(const AdviceDirections& directions, const AdvicePoint& point) {
  Assignments settings;
  for (std::size_t d = 0; d < point.size(); ++d) {
    const AdviceBranch& branch = branch_at(directions, point, d);
    settings.insert(settings.end(), branch.settings.begin(), branch.settings.end());
    if (point[d] == AdvicePlace{0, directions.all[d].scene_level}) continue;
    const AdviceLevel& level = level_at(directions, point, d);
    settings.insert(settings.end(), level.settings.begin(), level.settings.end());
  }
  return settings;
}

std::string place_label(const AdviceDirections& directions, const AdvicePoint& point, std::size_t d) {
  const AdviceDirection& direction = directions.all[d];
  const std::string &branch = branch_at(directions, point, d).label, &level = level_at(directions, point, d).label;
  if (!direction.converges) return direction.name + " " + branch;
  const std::string refined = level.empty() ? "" : direction.name + " " + level;
  return branch + (branch.empty() || refined.empty() ? "" : ", ") + refined;
}

std::string description_of(const AdviceDirections& directions, const AdvicePoint& point) {
  std::string text;
  for (std::size_t d = 0; d < point.size(); ++d) {
    if (d > mesh_direction && point[d] == AdvicePlace{0, directions.all[d].scene_level}) continue;
    const std::string label = place_label(directions, point, d);
    text += (text.empty() || label.empty() ? "" : ", ") + label;
  }
  return text;
}

std::string name_of(const AdviceDirections& directions, const AdvicePoint& point) {
  std::string name;
  for (char c : description_of(directions, point)) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+';
    if (plain)
      name += c;
    else if (c == ',')
      name += '_';
    else if (!name.empty() && name.back() != '-' && name.back() != '_')
      name += '-';
  }
  return name;
}

std::size_t distance(const AdvicePoint& a, const AdvicePoint& b) {
  std::size_t count = 0;
  for (std::size_t d = 0; d < a.size(); ++d) count += a[d] == b[d] ? 0 : 1;
  return count;
}

}  // namespace ixos
