#include "model/surface_pair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "model/crossing.hpp"
#include "term/pair/double_integral.hpp"
#include "term/pair/pair_friction.hpp"
#include "term/pair/pair_term.hpp"
#include "term/pair/two_passes.hpp"

namespace ixos {
namespace {

[[noreturn]] void refuse(const SurfacePair& pair, const std::string& why) {
  throw InputError(
      fmt::format("the interaction of the surfaces \"{}\" and \"{}\" {}", pair.side_set, pair.primary, why));
}

std::optional<Refusal> refusal_of_double_integral(const SurfacePair& pair) {
  const std::string start = "is not supported with Passes \"Double Integral\"";
  if (pair.law->powers().empty()) return Refusal{"Law", "", start + "; use \"Van der Waals\", or other Passes"};
  if (pair.cutoff > 0)
    return Refusal{"Cutoff", fmt::format("{}", pair.cutoff),
                   start + ", which acts at every distance; use 0, or other Passes"};
  if (pair.friction.type != FrictionType::None)
    return Refusal{"Friction/Type", "", start + "; use \"None\", or Passes \"One\" or \"Two\""};
  return std::nullopt;
}

std::optional<Refusal> refusal_of_friction(const SurfacePair& pair) {
  if (pair.friction.type == FrictionType::None) return std::nullopt;
  if (pair.is_with_itself())
    return Refusal{"Friction/Type", "",
                   "is not there for a surface that interacts with itself yet; use \"None\", or the surface of another "
                   "body as Primary Side Set"};
  if (pair.passes == Passes::TwoWithoutReaction)
    return Refusal{"Friction/Type", "",
                   "is not there with passes without reaction; use \"None\", or the Passes \"One\" or \"Two\""};
  if (pair.friction.current)
    return Refusal{"Friction/Threshold", "", "is not there between two bodies yet; use \"Lagged\""};
  return std::nullopt;
}

std::optional<Refusal> refusal_of_exclusion(const SurfacePair& pair) {
  const std::string exclusion = fmt::format("{}", pair.exclusion);
  if (!pair.is_with_itself()) {
    if (pair.exclusion == 0) return std::nullopt;
    return Refusal{"Exclusion", exclusion, "is for a surface that interacts with itself; use 0"};
  }
  const double range = pair.cutoff > 0 ? std::min(pair.cutoff, pair.law->range()) : pair.law->range();
  if (!(pair.exclusion > 0))
    return Refusal{"Exclusion", exclusion,
                   fmt::format("is too short for a surface with itself: it is the distance along the surface below "
                               "which its parts do not interact, and must be greater than 0; take about pi times the "
                               "cutoff{}",
                               std::isfinite(range) ? fmt::format(", {:.3g}", M_PI * range) : "")};
  if (!std::isfinite(range))
    return Refusal{"Cutoff", fmt::format("{}", pair.cutoff),
                   "is none, and a surface with itself needs one, or a law that ends"};
  return std::nullopt;
}

/// Returns all sides of the set, on every rank.
const std::vector<LocalSide>& all_sides(const LocalMesh& mesh, const Comm& comm, const std::string& name) {
  const std::size_t set = mesh.side_set(name);
  if (const auto whole = mesh.whole_side_sets.find(name); whole != mesh.whole_side_sets.end()) return whole->second;
  if (comm->getSize() == 1) return mesh.side_sets[set];
  throw InputError(fmt::format(
      "on several ranks, each needs all sides of the surface \"{}\", which interacts with another body: name it in "
      "local_part(), or use one rank",
      name));
}

/// Returns what is wrong with the nodal factor, or with its product with the factor of the place, at the nodes; empty
/// if nothing is.
std::string bad_factor(const SurfacePair& pair, const LocalMesh& mesh, const std::vector<int>& nodes) {
  if (!pair.nodal_factor.empty() && pair.nodal_factor.size() != static_cast<std::size_t>(mesh.nodes()))
    return fmt::format("has {} numbers as nodal factor, but this rank has {} nodes", pair.nodal_factor.size(),
                       mesh.nodes());
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for (const int local : nodes) {
    const auto node = static_cast<std::size_t>(local);
    std::array<double, 3> place{};
    std::copy_n(mesh.coordinates.begin() + static_cast<std::ptrdiff_t>(d * node), d, place.begin());
    double value = pair.nodal_factor.empty() ? 1 : pair.nodal_factor[node];
    if (pair.factor && value >= 0) value *= pair.factor(place);
    if (!std::isfinite(value) || value < 0)
      return fmt::format("has the factor {} at node {} of the mesh; it must be finite and at least 0", value,
                         mesh.message_number(node));
  }
  return "";
}

void refuse_common_nodes(const SurfacePair& pair, const LocalMesh& mesh, const std::vector<int>& a,
                         const std::vector<int>& b) {
  const std::set<int> own(a.begin(), a.end());
  for (const int node : b)
    if (own.count(node) > 0)
      refuse(pair, fmt::format("is that of surfaces with common nodes, such as node {} of the mesh; choose side sets "
                               "without common nodes, or one set twice, which then interacts with itself",
                               mesh.message_number(static_cast<std::size_t>(node))));
}

void refuse_overlap(const SurfacePair& pair, const Model& model, Interaction& term) {
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  const TermHistories histories = lone_histories(term);
  const Place at_rest{rest.data(), 0, &histories};
  const LowestPoint lowest = term.admissibility().lowest_point(at_rest);
  InteractionReport report;
  term.reports().report(at_rest, report);
  const double points = model.space().minimum(report.least_gap);
  if (lowest.gap <= 0)  // equal on all ranks
    refuse(pair, fmt::format("starts where they overlap or touch, least gap {:.6g} at {}; all gaps must be positive: "
                             "move one of the bodies",
                             lowest.gap, in_words(model.mesh(), rest.data(), lowest)));
  if (points <= 0)
    refuse(pair,
           fmt::format("starts where they overlap or touch, least gap {:.6g} at a quadrature point; all gaps must "
                       "be positive: move one of the bodies",
                       points));
}

template <std::size_t D>
void add_pair_of_dimension(Model& model, const SurfacePair& pair) {
  const LocalMesh& mesh = model.mesh();
  const Comm& comm = model.space().comm();
  PairSurfaces<D> surfaces;
  std::string problem;
  together<InputError>(comm, [&] {
    const auto surface = [&](const std::string& name) {
      return surface_patches<D>(mesh, all_sides(mesh, comm, name), pair.smoothing, name);
    };
    surfaces = {surface(pair.side_set), surface(pair.primary)};
    if (pair.exclusion == 0) refuse_common_nodes(pair, mesh, surfaces.secondary.nodes, surfaces.primary.nodes);
    problem = bad_factor(pair, mesh, surfaces.secondary.nodes);
  });
  if (problem = first_problem(comm, problem); !problem.empty()) refuse(pair, problem);
  const auto law = acting_law(pair);
  PairOptions options{pair.points, pair.margin, {pair.factor, pair.nodal_factor}, pair.exclusion};
  if (pair.passes == Passes::DoubleIntegral) options.points = 0;  // the least distance only says what is admissible
  options.share = pair.passes == Passes::Two ? 0.5 : 1;
  options.reacts = pair.passes != Passes::TwoWithoutReaction;
  std::vector<std::unique_ptr<Interaction>> frictions;
  const auto pass = [&](const PairSurfaces<D>& own) {
    if (law->domain() == GapDomain::All)
      options.depth = pair.exclusion > 0 ? HUGE_VAL : model.space().maximum(overlap_depth(mesh, own.primary));
    if (pair.friction.type != FrictionType::None) {
      const FrictionLaw friction(pair.friction, law);
      frictions.push_back(make_pair_friction<D>(mesh, own, model.pattern(), law, friction, options));
    }
    return make_pair_term<D>(mesh, own, model.pattern(), law, options);
  };
  std::unique_ptr<Interaction> term = pass(surfaces);
  if (pair.passes == Passes::DoubleIntegral) {
    const std::size_t nodes = surfaces.secondary.nodes.size() + surfaces.primary.nodes.size();
    if (nodes > most_nodes_of_double_integral)
      refuse(pair, fmt::format("is a double integral over surfaces of {} nodes; at most {} are allowed, because its "
                               "matrix is dense: use smaller side sets, or Passes One",
                               nodes, most_nodes_of_double_integral));
    term = make_double_integral<D>(mesh, surfaces, model.pattern(), std::move(term), PairKernel<D>(law->powers()),
                                   pair.points);
  } else if (pair.passes != Passes::One)
    term = two_passes(std::move(term), pass({surfaces.primary, surfaces.secondary}), options.reacts);
  if (law->domain() == GapDomain::Positive) refuse_overlap(pair, model, *term);
  model.add_interaction(std::move(term), pair.name);
  for (std::unique_ptr<Interaction>& friction : frictions) model.add_interaction(std::move(friction), pair.name);
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  model.update_couplings(rest.data());
}

}  // namespace

std::optional<Refusal> refusal_of(const SurfacePair& pair) {
  if (auto refusal = refusal_of_forces(pair)) return refusal;
  if (pair.law->has_history())
    return Refusal{"Law", "", "has a history, which surfaces of two bodies cannot have yet; use a law without one"};
  if (pair.passes == Passes::DoubleIntegral)
    if (auto refusal = refusal_of_double_integral(pair)) return refusal;
  if (pair.passes != Passes::One && pair.is_with_itself())
    return Refusal{"Passes", "", "is not there for a surface with itself; use \"One\""};
  if (pair.passes != Passes::One && (pair.factor || !pair.nodal_factor.empty()))
    return Refusal{"Passes", "", "is not there with a factor, which is that of the Side Set alone; use \"One\""};
  if (auto refusal = refusal_of_friction(pair)) return refusal;
  return refusal_of_exclusion(pair);
}

void add_pair(Model& model, const SurfacePair& pair) {
  model.check_open();
  if (const auto refusal = refusal_of(pair)) refuse(pair, "is not allowed: " + refusal->in_words());
  if (pair.passes == Passes::DoubleIntegral && model.mesh().axisymmetric)
    refuse(pair, "is a double integral, which does not support axisymmetric meshes; use Passes One or Two");
  if (model.mesh().dimension == 2)
    add_pair_of_dimension<2>(model, pair);
  else
    add_pair_of_dimension<3>(model, pair);
}

}  // namespace ixos
