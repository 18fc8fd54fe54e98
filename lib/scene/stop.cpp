#include "scene/stop.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/closest_name.hpp"

namespace ixos {
namespace {

const Probe& probe_named(const std::vector<Probe>& probes, const std::string& name) {
  std::vector<std::string> names;
  for (const Probe& probe : probes) {
    if (probe.name == name) return probe;
    names.push_back(probe.name);
  }
  if (names.empty()) throw InputError("probe \"" + name + "\" does not exist; Output/Probes is empty");
  throw InputError(no_such("probe", name, names, "Output/Probes has"));
}

}  // namespace

StopCriteria::StopCriteria(const SceneNode& list, const std::vector<Probe>& probes, const Model& model) {
  for (const SceneNode& node : list.sublists()) {
    Criterion criterion;
    criterion.name = node.name();
    if (node.text("Type") == "Detached") {
      if (!model.has_interactions()) node.refuse("Type", "\"Detached\" needs an interaction");
    } else {
      const SceneNode probe = node.sublist("Probe");
      criterion.probe =
          at(probe.path_of("Name"), [&]() -> const Probe* { return &probe_named(probes, probe.text("Name")); });
      criterion.quantity = probe.text("Quantity");
      if (criterion.quantity.back() - 'x' >= model.mesh().dimension)
        probe.refuse("Quantity", fmt::format("\"{}\" names z, but the mesh has {} dimensions", criterion.quantity,
                                             model.mesh().dimension));
      criterion.above = probe.text("Side") == "Above";
      criterion.limit = probe.number("Limit");
    }
    criteria_.push_back(criterion);
  }
}

std::string StopCriteria::reason(const Model& model, const State& state) {
  for (const Criterion& criterion : criteria_) {
    if (criterion.probe == nullptr) {
      const bool attached = model.interaction_report(state.u.data()).measure > 0;
      if (was_attached_ && !attached) return criterion.name + ": the surface is detached";
      was_attached_ = attached;
      continue;
    }
    const double value = probe_value(*criterion.probe, criterion.quantity, model, state);
    if (criterion.above ? value >= criterion.limit : value <= criterion.limit)
      return fmt::format("{}: {} of probe {} is {:.6g}, {} the limit {:.6g}", criterion.name, criterion.quantity,
                         criterion.probe->name, value, criterion.above ? "above" : "below", criterion.limit);
  }
  return "";
}

}  // namespace ixos
