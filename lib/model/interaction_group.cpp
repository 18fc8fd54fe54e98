#include "model/interaction_group.hpp"

#include <algorithm>
#include <limits>

#include "fem/cell_info.hpp"
#include "mesh/meridian.hpp"
#include "model/nodal_moment.hpp"
#include "rule/rule.hpp"

namespace ixos {
namespace {

const auto all = [](const Interaction&) { return true; };

}  // namespace

template <class Counts>
std::vector<double> InteractionGroup::force(const Counts& counts) const {
  std::vector<double> f(static_cast<std::size_t>(space_.local()), 0.0);
  for (const Interaction* term : terms_)
    if (counts(*term)) term->add_force(segment_at(at_), end_rule(), f.data());
  space_.condense(f.data());
  f.resize(static_cast<std::size_t>(space_.first_global()));
  return f;
}

InteractionReport InteractionGroup::report() const {
  InteractionReport report;
  report.force.assign(static_cast<std::size_t>(mesh_.dimension), 0.0);
  for (const Interaction* term : terms_) term->reports().report(at_, report);
  std::vector<double> sums = report.force;
  sums.push_back(report.measure);
  space_.sum(sums.data(), static_cast<int>(sums.size()));
  report.measure = sums.back();
  sums.pop_back();
  report.force = sums;
  report.least_gap = space_.minimum(report.least_gap);
  return report;
}

std::vector<double> InteractionGroup::moment() const {
  if (mesh_.axisymmetric) return {};
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  const std::vector<double> gradient = force(all);
  std::vector<double> sums(3, 0.0);
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh_.owned_nodes); ++node) {
    std::array<double, 3> own{};
    for (std::size_t i = 0; i < d; ++i) own[i] = -gradient[node * d + i];
    add_nodal_moment(mesh_, node, at_.u, own, {}, sums.data());
  }
  space_.sum(sums.data(), 3);
  if (d == 2) sums = {sums[2]};
  return sums;
}

std::vector<double> InteractionGroup::gap() const {
  std::vector<double> gap(static_cast<std::size_t>(mesh_.nodes()), std::numeric_limits<double>::quiet_NaN());
  for (const Interaction* term : terms_) term->reports().lower_nodal_gap(at_, gap.data());
  return gap;
}

std::vector<double> InteractionGroup::gap_of_both() const {
  std::vector<double> both = gap();
  for (const Interaction* term : terms_) term->reports().lower_facing_gap(at_, both.data());
  return both;
}

std::vector<double> InteractionGroup::normal() const {
  std::vector<double> normal(static_cast<std::size_t>(space_.first_global()), 0.0);
  for (const Interaction* term : terms_) term->reports().set_nodal_normal(at_, normal.data());
  return normal;
}

std::vector<double> InteractionGroup::traction() const { return traction(all); }

std::vector<double> InteractionGroup::friction() const {
  return traction([](const Interaction& term) { return term.has_friction(); });
}

template <class Counts>
std::vector<double> InteractionGroup::traction(const Counts& counts) const {
  std::vector<double> traction = over_measure(force(counts));
  if (!mesh_.axisymmetric) return traction;
  // On the axis the nodal force can vanish with the area, and no traction has a direction across the axis.
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  const std::vector<bool> on_axis = nodes_on_axis(mesh_);
  for (std::size_t i = 0; i < traction.size(); ++i)
    if (on_axis[i / d]) traction[i] = 0;
  for (const Interaction* term : terms_) {
    if (!counts(*term)) continue;
    std::vector<double> pressure(static_cast<std::size_t>(mesh_.nodes()), 0.0), normal(traction.size(), 0.0);
    term->reports().add_nodal(SurfaceNumber::Pressure, at_, pressure.data());
    term->reports().set_nodal_normal(at_, normal.data());
    divide_by_measure(pressure);
    for (std::size_t i = 0; i < traction.size(); ++i)
      if (on_axis[i / d]) traction[i] += pressure[i / d] * normal[i];
  }
  return traction;
}

bool InteractionGroup::has_friction() const {
  return std::any_of(terms_.begin(), terms_.end(), [](const Interaction* term) { return term->has_friction(); });
}

std::vector<double> InteractionGroup::friction_force() const {
  InteractionReport report;
  report.force.assign(static_cast<std::size_t>(mesh_.dimension), 0.0);
  for (const Interaction* term : terms_)
    if (term->has_friction()) term->reports().report(at_, report);
  space_.sum(report.force.data(), static_cast<int>(report.force.size()));
  return report.force;
}

FrictionReport InteractionGroup::friction_report() const {
  FrictionReport report;
  for (const Interaction* term : terms_)
    if (term->has_friction()) term->reports().report_friction(at_, report);
  double sums[] = {report.acting, report.sliding, report.sticking, report.slip, report.work, report.lag};
  space_.sum(sums, 6);
  return {sums[0], sums[1], sums[2], sums[3], sums[4], sums[5]};
}

bool InteractionGroup::has(SurfaceNumber number) const {
  return std::any_of(terms_.begin(), terms_.end(),
                     [number](const Interaction* term) { return term->reports().has(number); });
}

std::vector<double> InteractionGroup::mean(SurfaceNumber number) const {
  std::vector<double> means(static_cast<std::size_t>(mesh_.nodes()), 0.0);
  for (const Interaction* term : terms_) term->reports().add_nodal(number, at_, means.data());
  divide_by_measure(means);
  if (number == SurfaceNumber::Damage)
    for (double& value : means) value = std::clamp(value, 0.0, 1.0);
  return means;
}

namespace {

bool has_vanishing_corners(const LocalBlock& block) {
  const CellInfo& info = cell_info(block.type);
  return info.dimension == 3 && info.order == 2 && !is_cube(block.type) && !info.bubbles && block.global_cells > 0;
}

/// Sets means, `count` numbers a node, at the corners of triangles of six nodes, where int N_a dA vanishes: there they
/// are those of the means in the middle of the edges beside them. `area`: int N_a dA by node. Collective.
void take_corners_from_edges(const LocalMesh& mesh, const DofSpace& space, const std::vector<double>& area,
                             std::size_t count, std::vector<double>& means) {
  if (std::none_of(mesh.blocks.begin(), mesh.blocks.end(), has_vanishing_corners)) return;
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const std::size_t nodes = area.size();
  std::vector<double> areas(nodes * d, 0.0), ghosted(nodes * d, 0.0), sums(nodes * d, 0.0), edges(nodes, 0.0);
  for (std::size_t node = 0; node < nodes; ++node) {
    areas[node * d] = area[node];
    std::copy_n(&means[node * count], count, &ghosted[node * d]);
  }
  space.update_ghosts(areas.data());
  space.update_ghosts(ghosted.data());
  for (const LocalBlock& block : mesh.blocks) {
    if (!has_vanishing_corners(block)) continue;
    const CellInfo& info = cell_info(block.type);
    for (int cell = 0; cell < block.cells(); ++cell)
      for (std::size_t a = 0; a < info.node_corners.size(); ++a) {
        const auto middle = static_cast<std::size_t>(block.nodes[cell_entry(cell, info.nodes, static_cast<int>(a))]);
        if (info.node_corners[a].size() != 2 || !(areas[middle * d] > 0)) continue;
        for (const int own : info.node_corners[a]) {
          const auto corner = static_cast<std::size_t>(block.nodes[cell_entry(cell, info.nodes, own)]);
          edges[corner] += 1;
          for (std::size_t i = 0; i < count; ++i) sums[corner * d + i] += ghosted[middle * d + i];
        }
      }
  }
  for (std::size_t node = 0; node < nodes; ++node)
    for (std::size_t i = 0; i < count && edges[node] > 0; ++i)
      means[node * count + i] = sums[node * d + i] / edges[node];
}

}  // namespace

std::vector<double> InteractionGroup::over_measure(std::vector<double> force) const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  const std::vector<double> area = measure();
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] = area[i / d] > 0 && !mesh_.is_derivative(i / d) ? -force[i] / area[i / d] : 0.0;
  take_corners_from_edges(mesh_, space_, area, d, force);
  return force;
}

std::vector<double> InteractionGroup::pressure() const { return mean(SurfaceNumber::Pressure); }

void InteractionGroup::divide_by_measure(std::vector<double>& sums) const {
  space_.ties().condense(sums.data(), 1);
  const std::vector<double> area = measure();
  for (std::size_t node = 0; node < sums.size(); ++node)
    sums[node] = area[node] > 0 && !mesh_.is_derivative(node) ? sums[node] / area[node] : 0.0;
  take_corners_from_edges(mesh_, space_, area, 1, sums);
}

std::vector<double> InteractionGroup::measure() const {
  std::vector<double> measure(static_cast<std::size_t>(mesh_.nodes()), 0.0);
  CountedSides counted;
  for (const Interaction* term : terms_) term->reports().add_nodal_measure(counted, measure.data());
  space_.ties().condense(measure.data(), 1);
  return measure;
}

}  // namespace ixos
