#include "units/documented_unit.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace ixos {

std::vector<DocumentedUnit> documented_units(const std::string& documentation) {
  const auto open = documentation.find('['), close = documentation.find(']');
  if (open == std::string::npos || close == std::string::npos || close < open) return {};
  std::vector<DocumentedUnit> units;
  const std::string separator = ", ", use = " for ";
  for (std::size_t start = open + 1; start < close;) {
    const std::size_t end = std::min(documentation.find(separator, start), close);
    DocumentedUnit unit{documentation.substr(start, end - start), ""};
    if (const auto at = unit.expression.find(use); at != std::string::npos) {
      unit.use = unit.expression.substr(at + use.size());
      unit.expression.resize(at);
      for (const char* article : {"a ", "an "})
        if (unit.use.rfind(article, 0) == 0) unit.use.erase(0, std::strlen(article));
    }
    units.push_back(unit);
    start = end + separator.size();
  }
  if (units.size() == 1 && units[0].expression == "-") return {};
  return units;
}

}  // namespace ixos
