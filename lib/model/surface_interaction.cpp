#include "model/surface_interaction.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "model/crossing.hpp"
#include "term/surface_terms.hpp"

namespace ixos {
namespace {

void check(const SurfaceInteraction& interaction) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("the interaction of the surface \"{}\" {}", interaction.side_set, why));
  };
  if (!interaction.law) refuse("has no law");
  if (!interaction.obstacle) refuse("has no obstacle");
  if (interaction.points < 0 || interaction.points > 64)
    refuse(fmt::format("has {} Gauss points a direction; 0 to 64 are allowed", interaction.points));
  if (!(interaction.margin > 0 && interaction.margin < 1))
    refuse(fmt::format("has the step margin {}; it must be greater than 0 and less than 1", interaction.margin));
  try {
    check_cutoff(*interaction.law, interaction.cutoff);
  } catch (const InputError& error) {
    refuse(std::string("has a cutoff that is not allowed: ") + error.what());
  }
}

/// Returns "least gap -0.5 at node 3 of the mesh at (1, -0.5)" if some gap is not positive, otherwise an empty string.
/// Before a curved obstacle, quadrature points may be below while all points of the grid of lowest_point() are above:
/// then the text names no place. Equal on all ranks.
std::string place_below(const Model& model, const Interactions& terms, const std::vector<double>& u) {
  InteractionReport report;
  LowestPoint lowest;
  for (const auto& term : terms) {
    term->report(u.data(), report);
    if (const LowestPoint point = term->lowest_point(u.data()); point.gap < lowest.gap) lowest = point;
  }
  const double grid = model.space().minimum(lowest.gap), points = model.space().minimum(report.least_gap);
  std::string text;
  if (grid <= 0 && lowest.gap == grid)
    text = fmt::format("least gap {:.6g} at {}", grid, in_words(model.mesh(), u.data(), lowest));
  if (grid > 0 && points <= 0) text = fmt::format("least gap {:.6g} at a quadrature point", points);
  return first_problem(model.space().comm(), text);
}

}  // namespace

void check_cutoff(const GapLaw& law, double cutoff) {
  const double adhesion_gap = law.adhesion_gap();
  if (cutoff != 0 && !(cutoff > adhesion_gap))
    throw InputError(
        fmt::format("{} cuts off the attraction; it must be 0, or greater than the gap of largest "
                    "attraction, {:.6g}",
                    cutoff, adhesion_gap));
}

void add_interaction(Model& model, const SurfaceInteraction& interaction) {
  model.check_open();
  check(interaction);
  const LocalMesh& mesh = model.mesh();
  const std::size_t set = mesh.side_set(interaction.side_set);
  const auto law = interaction.cutoff > 0 ? interaction.law->cut_off(interaction.cutoff) : interaction.law;
  Interactions terms = make_surface_terms(mesh, mesh.side_sets[set], model.pattern(), law, interaction.obstacle,
                                          {interaction.points, interaction.margin});
  if (law->domain() == GapDomain::Positive) {
    const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
    const std::string place = place_below(model, terms, rest);
    const char* what = interaction.obstacle->half_space() != nullptr ? "wall" : "obstacle";
    if (!place.empty())
      throw InputError(
          fmt::format("the surface \"{}\" starts in or below the {}, {}; all gaps must be positive: move "
                      "the body or the {}, or change the mesh there",
                      interaction.side_set, what, place, what));
  }
  for (auto& term : terms) model.add_interaction(std::move(term), interaction.name);
}

}  // namespace ixos
