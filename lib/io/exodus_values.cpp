#include "io/exodus_values.hpp"

#include "base/closest_name.hpp"
#include "base/error.hpp"

namespace ixos {
namespace {

constexpr int name_length = 255;
constexpr int most_variables = 10000;  // more are nonsense, not a reason to read on

std::vector<std::string> nodal_names(const ExodusHandle& file) {
  ex_set_max_name_length(file, name_length);
  int count = 0;
  std::vector<std::string> names;
  if (ex_get_variable_param(file, EX_NODAL, &count) < 0 || count > most_variables) return names;
  for (int i = 0; i < count; ++i) {
    std::vector<char> text(name_length + 1, '\0');
    if (ex_get_variable_name(file, EX_NODAL, i + 1, text.data()) < 0) break;
    names.emplace_back(text.data());
  }
  return names;
}

}  // namespace

std::vector<double> last_nodal_values(const ExodusHandle& file, const std::string& name, int64_t nodes) {
  const std::vector<std::string> names = nodal_names(file);
  std::size_t place = 0;
  while (place < names.size() && names[place] != name) ++place;
  if (place == names.size()) throw InputError(file.path() + ": " + no_such("nodal field", name, names, "The file has"));
  const int64_t times = ex_inquire_int(file, EX_INQ_TIME);
  if (times < 1)
    throw InputError(file.path() + ": the nodal field \"" + name + "\" has no values: the file has no times");
  std::vector<double> values(static_cast<std::size_t>(nodes));
  if (ex_get_var(file, static_cast<int>(times), EX_NODAL, static_cast<int>(place) + 1, 1, nodes, values.data()) < 0)
    throw InputError(file.path() + ": the nodal field \"" + name + "\" cannot be read: the file is damaged");
  return values;
}

}  // namespace ixos
