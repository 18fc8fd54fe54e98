#include "study/common/tolerance.hpp"

#include <cstdlib>

#include "base/error.hpp"
#include "base/text.hpp"

namespace ixos {

double read_tolerance(const std::string& option, const std::string& text) {
  std::string digits = trimmed(text);
  const bool percent = !digits.empty() && digits.back() == '%';
  if (percent) digits = trimmed(digits.substr(0, digits.size() - 1));
  char* end = nullptr;
  const double value = std::strtod(digits.c_str(), &end) / (percent ? 100 : 1);
  if (digits.empty() || end != digits.c_str() + digits.size() || !(value >= 1e-8 && value < 1))
    throw InputError(
        option + ": \"" + text +
        "\" is no tolerance; write a part of the quantity of at least 1e-8 and less than 1, as 1% or 0.01");
  return value;
}

}  // namespace ixos
