#include "interaction/law_parameters.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ixos {

void check_derived(const SceneNode& node, const std::string& names,
                   const std::vector<std::pair<std::string, double>>& derived) {
  for (const auto& [name, value] : derived)
    if (!std::isfinite(value) || !(value > 0))
      node.refuse("", fmt::format("{} are too extreme: the {}, {}, must be positive and finite", names, name, value));
}

}  // namespace ixos
