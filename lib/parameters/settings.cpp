#include "parameters/settings.hpp"

#include <Teuchos_Array.hpp>
#include <type_traits>

namespace ixos {

void set(Teuchos::ParameterList& list, const Settings& settings) {
  for (const Setting& setting : settings)
    std::visit(
        [&](const auto& value) {
          if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::vector<double>>)
            list.set(setting.name, Teuchos::Array<double>(value));
          else
            list.set(setting.name, value);
        },
        setting.value);
}

}  // namespace ixos
