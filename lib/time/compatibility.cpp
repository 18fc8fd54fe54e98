#include "time/compatibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "material/elastic_law.hpp"
#include "model/traits.hpp"

namespace ixos {

bool needs_discrete_gradient(const Table& table) {
  return std::any_of(table.stages.begin(), table.stages.end(),
                     [](const Stage& stage) { return stage.elastic.mean == Mean::DiscreteGradient; });
}

bool has_discrete_gradient(const Material& material) {
  return material.formulation == Formulation::Standard && material.law->has_discrete_gradient();
}

namespace {

/// Returns what is wrong with the scheme for branches with that update, in words that follow its name.
std::string why_not_by(const Table& table, HistoryUpdate update) {
  if (needs_discrete_gradient(table)) return "needs a discrete gradient, which branches do not have";
  if (is_explicit(table)) return "is explicit: its forces know no history within a step";
  for (std::size_t s = 0; s < table.stages.size(); ++s)
    if (const double time = table.stages[s].elastic.mean_time(); !(time > 0 && time <= 1 + 1e-12))
      return fmt::format(
          "takes the elastic force of stage {} at a mean time of {:.4g} times the stage; branches need one above 0 and "
          "of at most 1",
          s + 1, time);
  const bool over_step = table.stages.size() == 1 && std::abs(table.stages.front().elastic.mean_time() - 0.5) < 1e-12;
  if (update == HistoryUpdate::SecondOrder && !over_step)
    return "takes the elastic force at the end of a stage, which the history update \"Second Order\" does not fit";
  return "";
}

}  // namespace

std::string why_no_branches(const Material& material, const Table& table) {
  std::string why = why_no_branches(material);
  if (!why.empty()) return why;
  why = why_not_by(table, material.history_update);
  if (why.empty()) return "";
  return fmt::format("the scheme \"{}\" {}; use another scheme, such as \"Average Vector Field\"", table.name, why);
}

std::string why_no_pairs(const Table& table, bool reacts) {
  for (const Stage& stage : table.stages)
    if (stage.interaction.mean == Mean::Exact)
      return fmt::format(
          "the scheme \"{}\" takes the mean of an interaction in closed form, as with 0 Interaction Points, which two "
          "surfaces do not have; use 1 or more Interaction Points, such as 5",
          table.name);
  if (!reacts && needs_discrete_gradient(table))
    return fmt::format(
        "the scheme \"{}\" needs a discrete gradient, which Passes \"Two Without Reaction\" and \"Double Integral\" do "
        "not have; use Passes Two, or the scheme \"Average Vector Field\"",
        table.name);
  return "";
}

std::string why_no_bodies(const Table& table, bool turning, bool carrying) {
  const auto of = [&](const char* why) { return fmt::format("the scheme \"{}\" {}", table.name, why); };
  if (is_explicit(table))
    return of("is explicit: its longest stable step does not know rigid bodies; use an implicit one");
  if (is_static(table)) return "";
  const bool momentum = table.closing == Closing::Collocate;
  for (const Stage& stage : table.stages) {
    if (momentum && turning && (table.stages.size() > 1 || stage.end != 1))
      return of("balances momentum over several stages, which bodies that turn cannot; use one of a single stage");
    if (!momentum && carrying && stage.elastic.kept_weight != 0)
      return of(
          "weights forces of both ends of a step, which bodies that turn and carry nodes cannot: they would lose its "
          "order; hold their rotations, or use a scheme such as Newmark or Energy-Momentum");
    for (const RulePoint& point : stage.elastic.points)
      if (!momentum && turning && point.to != 1)
        return of("takes forces within a step, which bodies that turn cannot; use one such as Newmark");
  }
  return "";
}

void check_compatible(const Model& model, const Table& table) {
  for (const NamedInteraction& named : model.interactions())
    for (const Stage& stage : table.stages)
      if (!named.term->follows(stage.interaction.mean))
        throw InputError(fmt::format("the interaction \"{}\": {}", named.name, why_no_pairs(table, false)));
  if (!model.rigid_bodies().empty()) {
    bool carrying = false;
    for (const CarriedNodes& nodes : model.carried_nodes()) carrying = carrying || nodes.body().turns();
    if (const std::string why = why_no_bodies(table, has_turning_bodies(model), carrying); !why.empty())
      throw InputError("Rigid Bodies: " + why);
  }
  for (const Material& material : model.materials()) {
    const std::string block = " of block \"" + material.block + "\"";
    if (const std::string why = why_no_branches(material, table); !material.branches.empty() && !why.empty())
      throw InputError(fmt::format("the Maxwell branches{}: {}", block, why));
    if (needs_discrete_gradient(table) && !has_discrete_gradient(material))
      throw InputError(fmt::format(
          "the scheme \"{}\" needs a discrete gradient, and the {}{} has none; use another one, or the "
          "scheme \"Average Vector Field\"",
          table.name, material.formulation != Formulation::Standard ? "formulation" : "elastic law", block));
  }
}

}  // namespace ixos
