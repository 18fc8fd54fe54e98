#include "model/surface_interaction.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "interaction/area_factor.hpp"
#include "model/crossing.hpp"
#include "term/wall/friction_term.hpp"
#include "term/wall/moved_interaction.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

void check(const SurfaceInteraction& interaction, const LocalMesh& mesh) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("the interaction of the surface \"{}\" {}", interaction.side_set, why));
  };
  if (const auto refusal = refusal_of_forces(interaction)) refuse("is not allowed: " + refusal->in_words());
  if (!interaction.obstacle) refuse("has no obstacle");
  if (mesh.axisymmetric && !interaction.obstacle->is_coaxial())
    refuse(
        "has an obstacle that is no body of revolution about the y axis, as an axisymmetric mesh needs: a flat wall "
        "with a normal along y, a sphere or a cone on the axis, or a cylinder on the axis with the Axis {0, 1}");
  if (interaction.motion && interaction.motion->dimension() != mesh.dimension)
    refuse(fmt::format("has an obstacle whose motion has {} dimensions, but the mesh has {}",
                       interaction.motion->dimension(), mesh.dimension));
  if (interaction.motion && interaction.motion->moves() && !interaction.rigid_body.empty())
    refuse("has an obstacle that belongs to a rigid body and also has a motion");
  if (mesh.axisymmetric && interaction.motion && (interaction.motion->turns() || interaction.motion->translates(0)))
    refuse("has an obstacle that moves off the axis of an axisymmetric mesh: it may translate along y only");
}

/// Returns how the obstacle moves; nothing if it rests.
std::optional<FrameMotion> motion_of(const Model& model, const SurfaceInteraction& interaction) {
  if (!interaction.rigid_body.empty()) {
    const std::size_t body = model.rigid_bodies().find(interaction.rigid_body);
    const auto first = model.first_number(body);
    return FrameMotion(CarryingBody{&model.rigid_bodies()[body], first});
  }
  if (interaction.motion && interaction.motion->moves()) return FrameMotion(*interaction.motion);
  return std::nullopt;
}

/// Returns "in or below the wall, least gap -0.5 at node 3 of the mesh at (1, -0.5)" if some gap is not above
/// `limit`, 0 or minus infinity, otherwise an empty string; `what` is "wall" or "obstacle".
/// Before a curved obstacle, quadrature points may be below while all points of the grid of lowest_point() are above:
/// then the text names no place. Equal on all ranks.
std::string place_below(const Model& model, const Interactions& terms, const std::vector<double>& u, double time,
                        double limit, const char* what) {
  InteractionReport report;
  LowestPoint lowest;
  for (const auto& term : terms) {
    const TermHistories histories = lone_histories(*term);
    const Place rest{u.data(), time, &histories};
    term->reports().report(rest, report);
    if (const LowestPoint point = term->admissibility().lowest_point(rest); point.gap < lowest.gap) lowest = point;
  }
  const double grid = model.space().minimum(lowest.gap), points = model.space().minimum(report.least_gap);
  std::string text;
  if (grid <= limit && lowest.gap == grid) {
    const std::string place = in_words(model.mesh(), u.data(), lowest);
    text = std::isinf(grid) ? fmt::format("beyond the edge of the {}, at {}", what, place)
                            : fmt::format("in or below the {}, least gap {:.6g} at {}", what, grid, place);
  }
  if (grid > limit && points <= limit)
    text = std::isinf(points) ? fmt::format("beyond the edge of the {}, at a quadrature point", what)
                              : fmt::format("in or below the {}, least gap {:.6g} at a quadrature point", what, points);
  return first_problem(model.space().comm(), text);
}

/// Returns the interaction's factor as a function that gives 0 where it is not allowed, and writes the first such place
/// to `problem`; null if there is none.
PlaceFactor checked_factor(const SurfaceInteraction& interaction, int dimension, std::string& problem) {
  if (!interaction.factor) return nullptr;
  return [&, dimension](const std::array<double, 3>& x) {
    const double value = interaction.factor(x);
    if (std::isfinite(value) && value >= 0) return value;
    if (problem.empty())
      problem = fmt::format("the factor at ({}) of the surface \"{}\" is {}; it must be finite and at least 0",
                            dimension == 2 ? fmt::format("{:.6g}, {:.6g}", x[0], x[1])
                                           : fmt::format("{:.6g}, {:.6g}, {:.6g}", x[0], x[1], x[2]),
                            interaction.side_set, value);
    return 0.0;
  };
}

std::size_t corners_of_side(const LocalMesh& mesh, const LocalSide& side) {
  return side_nodes(corner_type(mesh.blocks[static_cast<std::size_t>(side.block)].type), side.side).size();
}

/// Returns the first corner of the surface whose factor is not allowed, in words; empty if all are.
std::string bad_nodal_factor(const SurfaceInteraction& interaction, const LocalMesh& mesh, std::size_t set) {
  const std::vector<double>& factor = interaction.nodal_factor;
  if (factor.empty()) return "";
  if (factor.size() != static_cast<std::size_t>(mesh.nodes()))
    return fmt::format("the nodal factor of the surface \"{}\" has {} numbers, but this rank has {} nodes",
                       interaction.side_set, factor.size(), mesh.nodes());
  for (const LocalSide& side : mesh.side_sets[set])
    for (std::size_t a = 0; a < corners_of_side(mesh, side); ++a) {
      const auto node = static_cast<std::size_t>(side.nodes[a]);
      if (!std::isfinite(factor[node]) || factor[node] < 0)
        return fmt::format(
            "the factor at node {} of the mesh, on the surface \"{}\", is {}; it must be finite and at "
            "least 0",
            mesh.message_number(node), interaction.side_set, factor[node]);
    }
  return "";
}

/// Returns the kinds of sides in a set on all ranks. Collective.
std::vector<SideKind> kinds_on_all_ranks(const Model& model, const std::vector<LocalSide>& sides) {
  constexpr std::size_t sides_of_a_cell = 6;
  std::vector<double> counts(model.mesh().blocks.size() * sides_of_a_cell, 0.0);
  for (const LocalSide& side : sides)
    counts[static_cast<std::size_t>(side.block) * sides_of_a_cell + static_cast<std::size_t>(side.side)] += 1;
  model.space().sum(counts.data(), static_cast<int>(counts.size()));
  std::vector<SideKind> kinds;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) kinds.push_back({static_cast<int>(i / sides_of_a_cell), static_cast<int>(i % sides_of_a_cell)});
  return kinds;
}

}  // namespace

std::shared_ptr<const GapLaw> law_before(const Obstacle& obstacle, const std::shared_ptr<const GapLaw>& law,
                                         double cutoff, int body_dimension) {
  const auto own = cutoff > 0 ? law->cut_off(cutoff) : law;
  if (own->range() > obstacle.reach())
    throw InputError(
        fmt::format("the distance from this obstacle is smooth up to {:.6g} only, and the law acts beyond: choose a "
                    "Cutoff of at most {:.6g}, or the Gap \"Vertical\"",
                    obstacle.reach(), obstacle.reach()));
  const auto factor = obstacle.area_factor(body_dimension);
  return factor ? with_area_factor(own, *factor) : own;
}

void add_interaction(Model& model, const SurfaceInteraction& interaction) {
  model.check_open();
  const LocalMesh& mesh = model.mesh();
  check(interaction, mesh);
  const std::size_t set = mesh.side_set(interaction.side_set);
  const auto law = law_before(*interaction.obstacle, interaction.law, interaction.cutoff, mesh.body_dimension());
  const Comm& comm = model.space().comm();
  if (const std::string problem = first_problem(comm, bad_nodal_factor(interaction, mesh, set)); !problem.empty())
    throw InputError(problem);
  std::string bad_factor;
  const SurfaceFactor factor{checked_factor(interaction, mesh.dimension, bad_factor), interaction.nodal_factor};
  const SurfaceOptions options{interaction.points, interaction.margin, factor,
                               kinds_on_all_ranks(model, mesh.side_sets[set])};
  Interactions terms =
      make_surface_terms(mesh, mesh.side_sets[set], model.pattern(), law, interaction.obstacle, options);
  if (const std::string problem = first_problem(comm, bad_factor); !problem.empty()) throw InputError(problem);
  if (interaction.friction.type != FrictionType::None) {
    const FrictionLaw friction(interaction.friction, law);
    // Also without a threshold, so that a study of the coefficient has the same columns and fields at 0.
    for (auto& term :
         make_friction_terms(mesh, mesh.side_sets[set], model.pattern(), friction, interaction.obstacle, options))
      terms.push_back(std::move(term));
  }
  if (const auto motion = motion_of(model, interaction))
    for (auto& term : terms)
      term = std::make_unique<MovedInteraction>(std::move(term), *motion, mesh, mesh.side_sets[set], model.pattern());
  const bool positive = law->domain() == GapDomain::Positive;
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  const char* what = interaction.obstacle->half_space() != nullptr ? "wall" : "obstacle";
  // A law that is defined at every gap still needs an obstacle below it.
  const double limit = positive ? 0 : -std::numeric_limits<double>::infinity();
  const std::string place = std::isnan(interaction.initial_time)
                                ? ""
                                : place_below(model, terms, rest, interaction.initial_time, limit, what);
  if (!place.empty())
    throw InputError(fmt::format("the surface \"{}\" starts {}; {}: move the body or the {}, or change the mesh there",
                                 interaction.side_set, place,
                                 positive ? "all gaps must be positive" : "no surface may be there", what));
  for (auto& term : terms) model.add_interaction(std::move(term), interaction.name);
}

}  // namespace ixos
