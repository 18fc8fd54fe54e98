#include "model/crossing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/agreement.hpp"

namespace ixos {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Calls visit(name, its admissibility) for the interactions that need positive gaps, or for the others.
template <class Visit>
void for_each_interaction(const Model& model, bool positive, const Visit& visit) {
  for (const NamedInteraction& named : model.interactions())
    if (named.term->admissibility().needs_positive_gaps() == positive) visit(named.name, named.term->admissibility());
}

std::string coordinates(const std::array<double, 3>& x, int dimension) {
  return dimension == 2 ? fmt::format("({:.6g}, {:.6g})", x[0], x[1])
                        : fmt::format("({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
}

}  // namespace

std::string in_words(const LocalMesh& mesh, const double* u, const LowestPoint& point) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double size = 0;
  for (double x : point.place) size = std::max(size, std::abs(x));
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {
    if (mesh.is_derivative(node) || mesh.is_added(node)) continue;
    double distance = 0;
    for (std::size_t i = 0; i < d; ++i)
      distance = std::max(distance, std::abs(mesh.coordinates[node * d + i] + u[node * d + i] - point.place[i]));
    if (distance <= 1e-12 * size)
      return fmt::format("node {} of the mesh at {}", mesh.message_number(node),
                         coordinates(point.place, mesh.dimension));
  }
  return "the place " + coordinates(point.place, mesh.dimension) + " on a side";
}

std::string crossing(const Model& model, const Segment& way) {
  const Place end = way.end();
  LowestPoint lowest;
  std::string name;
  bool any = false, passes = false;
  for (const bool positive : {true, false})
    for_each_interaction(model, positive, [&](const std::string& own, const Admissibility& term) {
      any = true;
      if (way.from != nullptr) {
        const LowestPoint passed = term.passage(way);
        if (passed.gap < std::min(lowest.gap, 0.0)) {
          lowest = passed;
          name = own;
          passes = true;
        }
      }
      if (positive && term.is_clear(end)) return;
      const LowestPoint point = term.lowest_point(end);
      if (point.gap > (positive ? 0 : -infinity) || !(point.gap < lowest.gap)) return;
      lowest = point;
      name = own;
      passes = false;
    });
  if (!any) return "";
  const double least = model.space().minimum(lowest.gap);
  if (least > 0) return "";
  std::string text;
  if (lowest.gap == least && passes)
    text = fmt::format(
        "the surface of interaction \"{}\" passes through the obstacle, or through the other body, within one step: "
        "the gap falls to {:.6g} L0 on the way to {}",
        name, least, in_words(model.mesh(), end.u, lowest));
  else if (lowest.gap == least)
    text = std::isinf(least)
               ? fmt::format("the surface of interaction \"{}\" is beyond the edge of the obstacle, at {}", name,
                             in_words(model.mesh(), end.u, lowest))
               : fmt::format("the surface of interaction \"{}\" crosses the obstacle: the gap of {} is {:.6g} L0", name,
                             in_words(model.mesh(), end.u, lowest), least);
  return first_problem(model.space().comm(), text);
}

double least_free_gap(const Model& model, const Place& at) {
  double least = infinity;
  bool any = false;
  for_each_interaction(model, false, [&](const std::string&, const Admissibility& term) {
    any = true;
    least = std::min(least, term.lowest_point(at).gap);
  });
  return any ? model.space().minimum(least) : least;
}

}  // namespace ixos
