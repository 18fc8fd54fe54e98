#include "scene/interactions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "model/half_space_term.hpp"
#include "scene/list_access.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

HalfSpace half_space(const List& list, const std::string& path, std::size_t dimension) {
  HalfSpace wall;
  wall.normal = {};
  const auto point = numbers(list, path, "Point", dimension, std::vector<double>(dimension, 0.0));
  std::vector<double> up(dimension, 0.0);
  up.back() = 1;
  const auto normal = numbers(list, path, "Normal", dimension, up);
  double largest = 0;
  for (double n : normal) largest = std::max(largest, std::abs(n));
  if (!(largest > 0)) throw InputError(path + "/Normal is zero: it must point out of the wall");
  double square = 0;
  for (double n : normal) square += n / largest * (n / largest);
  for (std::size_t d = 0; d < dimension; ++d) {
    wall.point[d] = point[d];
    wall.normal[d] = normal[d] / largest / std::sqrt(square);
  }
  return wall;
}

void add_interaction(const List& list, const std::string& path, Model& model) {
  const LocalMesh& mesh = model.mesh();
  const std::size_t set = at(path + "/Side Set", [&] { return mesh.side_set(list.get<std::string>("Side Set")); });
  const VanDerWaals law(list.get<double>("Gamma L"), list.get<double>("Gamma W"));
  if (!std::isfinite(law.c1()) || !(law.c1() > 0) || !std::isfinite(law.c2()) || !(law.c2() > 0))
    throw InputError(
        fmt::format("{}: Gamma L and Gamma W are too extreme: c1 = {} and c2 = {} must be positive and finite", path,
                    law.c1(), law.c2()));
  const auto cutoff = list.get<double>("Cutoff");
  if (cutoff > 0 && !(cutoff > law.adhesion_gap()))
    throw InputError(fmt::format(
        "{}/Cutoff: {} cuts off the attraction; it must be 0, or greater than the gap of largest attraction, {:.6g}",
        path, cutoff, law.adhesion_gap()));
  const HalfSpace wall = half_space(list, path, static_cast<std::size_t>(mesh.dimension));
  auto terms = make_half_space_terms(mesh, mesh.side_sets[set], model.pattern(), law, wall,
                                     {list.get<int>("Surface Points"), cutoff, list.get<double>("Step Margin")});
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  InteractionReport report;
  for (const auto& term : terms) term->report(rest.data(), report);
  const double gap = model.space().minimum(report.least_gap);
  if (!(gap > 0))
    throw InputError(
        fmt::format("{}: the surface \"{}\" starts in or below the wall, least gap {:.6g}; all gaps must be positive",
                    path, list.get<std::string>("Side Set"), gap));
  for (auto& term : terms) model.add_interaction(std::move(term));
}

}  // namespace

void add_interactions(const List& list, Model& model) {
  for (const std::string& name : sublists(list)) add_interaction(list.sublist(name), "Interactions/" + name, model);
}

}  // namespace ixos
