#include "scene/read/probes.hpp"

namespace ixos {

std::vector<Probe> find_probes(const SceneNode& list, const Model& model) {
  std::vector<Probe> probes;
  for (const SceneNode& node : list.sublists()) {
    const auto place = node.numbers("Point", static_cast<std::size_t>(model.mesh().dimension), {});
    if (place.empty())
      throw InputError(node.path_of("Point") + " is missing: the position of the probe in the reference configuration");
    probes.push_back(
        {node.name(), place, at(node.path_of("Point"), [&] { return locate(model.mesh(), model.space(), place); })});
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
