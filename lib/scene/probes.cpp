#include "scene/probes.hpp"

#include <Teuchos_Array.hpp>

#include "scene/list_access.hpp"

namespace ixos {

std::vector<Probe> find_probes(const Teuchos::ParameterList& list, const Model& model) {
  std::vector<Probe> probes;
  for (const std::string& name : sublists(list)) {
    const std::string path = "Output/Probes/" + name;
    check_column_name(path, name);
    const auto d = static_cast<std::size_t>(model.mesh().dimension);
    const auto place = numbers(list.sublist(name), path, "Point", d, {});
    if (place.empty())
      throw InputError(path + "/Point is missing: the position of the probe in the reference configuration");
    probes.push_back({name, place, at(path + "/Point", [&] { return locate(model.mesh(), model.space(), place); })});
  }
  return probes;
}

double probe_value(const Probe& probe, const std::string& quantity, const Model& model, const State& state) {
  const auto axis = static_cast<std::size_t>(quantity.back() - 'x');
  const std::vector<double>& field = quantity.front() == 'v' ? state.v : state.u;
  const double value = probe.point.value(model.space(), field)[axis];
  return quantity.size() == 1 ? probe.place[axis] + value : value;
}

}  // namespace ixos
