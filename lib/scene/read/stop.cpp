#include "scene/read/stop.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/closest_name.hpp"
#include "model/set_reactions.hpp"
#include "model/state_report.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"

namespace ixos {
namespace {

enum class Kind { Probe, Detached, Reaction };

/// The entries of "Probe".
struct ProbeLimit {
  std::string name = required;
  std::string quantity = "y";
  bool above = true;
  double limit = 0;
};

/// The entries of "Reaction".
struct ReactionLimit {
  std::string set = required;
  std::string component = "y";
  bool above = true;
  double limit = 0;
};

/// The entries of a criterion.
struct Parameters {
  Kind kind = Kind::Probe;
  ProbeLimit probe{};
  ReactionLimit reaction{};
};

Options<ProbeLimit> probe_options() {
  return Options<ProbeLimit>()
      .add("Name", &ProbeLimit::name, "Name of a probe in Output/Probes.")
      .add("Quantity", &ProbeLimit::quantity, "Coordinate (x), displacement (ux) or velocity (vx) of the probe.",
           one_of({"x", "y", "z", "ux", "uy", "uz", "vx", "vy", "vz"}))
      .choose("Side", &ProbeLimit::above, {{"Above", true}, {"Below", false}},
              "Side of the limit on which the run ends.")
      .require("Limit", &ProbeLimit::limit,
               "Limit of the quantity [L0 for a coordinate or displacement, L0/T0 for a velocity].", any_number());
}

Options<ReactionLimit> reaction_options() {
  return Options<ReactionLimit>()
      .add("Node Set", &ReactionLimit::set, "Node set whose displacements are prescribed.")
      .add("Component", &ReactionLimit::component, "Direction of the force.", one_of({"x", "y", "z"}))
      .choose("Side", &ReactionLimit::above, {{"Above", true}, {"Below", false}},
              "Side of the limit on which the run ends.")
      .require(
          "Limit", &ReactionLimit::limit,
          "Limit of the reaction of the set: the sum of the forces on the body there [E0 L0 for a set in 2D, E0 L0^2 "
          "for a set in 3D]. On an axisymmetric mesh it has the unit of 3D.",
          any_number());
}

const Options<Parameters>& options() {
  static const Options<Parameters> all =
      Options<Parameters>()
          .choose_list("Type", &Parameters::kind,
                       {{"Probe", Kind::Probe}, {"Detached", Kind::Detached}, {"Reaction", Kind::Reaction}},
                       "Kind of criterion. Probe is met when a probe passes a limit; Detached when the contact of a "
                       "surface that was in contact is lost; Reaction when the force that holds a node set passes a "
                       "limit, such as a preload.")
          .sublist("Probe", &Parameters::probe, probe_options(), "A limit on a probe.")
          .sublist("Reaction", &Parameters::reaction, reaction_options(), "A limit on the reaction of a node set.");
  return all;
}

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

void declare_stop(Teuchos::ParameterList& list) { options().declare(list); }

StopCriteria::StopCriteria(const SceneNode& list, const std::vector<Probe>& probes, const Model& model) {
  for (const SceneNode& node : list.sublists()) {
    Criterion criterion;
    criterion.name = node.name();
    const Parameters p = options().read(node);
    if (p.kind == Kind::Detached) {
      if (!model.has_interactions()) node.refuse("Type", "\"Detached\" needs an interaction");
    } else if (p.kind == Kind::Reaction) {
      criterion.set = p.reaction.set;
      criterion.quantity = p.reaction.component;
      if (criterion.quantity.back() - 'x' >= model.mesh().dimension)
        node.sublist("Reaction")
            .refuse("Component",
                    fmt::format("\"{}\" is no direction of {} dimensions", criterion.quantity, model.mesh().dimension));
      at(node.sublist("Reaction").path_of("Node Set"), [&] { check_held(model, criterion.set); });
      criterion.above = p.reaction.above;
      criterion.limit = p.reaction.limit;
    } else {
      const SceneNode probe = node.sublist("Probe");
      criterion.probe = at(probe.path_of("Name"), [&]() -> const Probe* { return &probe_named(probes, p.probe.name); });
      criterion.quantity = p.probe.quantity;
      if (criterion.quantity.back() - 'x' >= model.mesh().dimension)
        probe.refuse("Quantity", fmt::format("\"{}\" names z, but the mesh has {} dimensions", criterion.quantity,
                                             model.mesh().dimension));
      criterion.above = p.probe.above;
      criterion.limit = p.probe.limit;
    }
    criteria_.push_back(criterion);
  }
}

bool StopCriteria::passes(const Criterion& criterion, double value) {
  return criterion.above ? value >= criterion.limit : value <= criterion.limit;
}

std::string StopCriteria::reason(const Model& model, const State& state) {
  for (const Criterion& criterion : criteria_) {
    if (!criterion.set.empty()) {
      const auto axis = static_cast<std::size_t>(criterion.quantity.back() - 'x');
      const double force = set_reaction(model, state.reaction, criterion.set)[axis];
      if (!passes(criterion, force)) continue;
      return fmt::format("{}: the reaction {} of {} is {:.6g}, {} the limit {:.6g}", criterion.name, criterion.quantity,
                         criterion.set, force, criterion.above ? "above" : "below", criterion.limit);
    }
    if (criterion.probe == nullptr) {
      const bool attached = StateReport(model, state).interaction_report().measure > 0;
      if (was_attached_ && !attached) return criterion.name + ": the surface is detached";
      was_attached_ = attached;
      continue;
    }
    const double value = probe_value(*criterion.probe, criterion.quantity, model, state);
    if (passes(criterion, value))
      return fmt::format("{}: {} of probe {} is {:.6g}, {} the limit {:.6g}", criterion.name, criterion.quantity,
                         criterion.probe->name, value, criterion.above ? "above" : "below", criterion.limit);
  }
  return "";
}

}  // namespace ixos
