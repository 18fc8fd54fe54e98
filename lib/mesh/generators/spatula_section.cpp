#include "mesh/generators/spatula_section.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

SpatulaLayers::SpatulaLayers(const SpatulaShape& shape, const SpatulaDivisions& divisions)
    : core_layers_(divisions.core_layers), rings_(divisions.rings) {
  const int layers = core_layers_ + 2 * rings_;
  heights_.push_back(0);
  for (int i = 0; i < layers; ++i)
    heights_.push_back(heights_.back() + std::pow(shape.layer_ratio, static_cast<double>(i) / (layers - 1)));
  for (double& height : heights_) height /= heights_.back();
  heights_.back() = 1;
}

double SpatulaLayers::height(const SectionNode& node) const {
  const auto at = [this](int layer) { return heights_[static_cast<std::size_t>(layer)]; };
  const double lowest = at(rings_), highest = at(rings_ + core_layers_);
  const double share = (at(rings_ + node.layer) - lowest) / (highest - lowest);
  return (1 - share) * at(rings_ - node.ring) + share * at(rings_ + core_layers_ + node.ring);
}

std::array<double, 2> disk_node(const SpatulaShape& shape, const SpatulaDivisions& divisions, const SectionNode& node) {
  const double radius = shape.shaft_diameter / 2;
  const double xi = 2.0 * node.column / divisions.core_cells - 1;
  const double eta = 2.0 * node.layer / divisions.core_layers - 1;
  // The narrow ends' share of the circle: all angles alike would make them too narrow in a flat section.
  const double end =
      std::clamp(M_PI / 2 * divisions.core_layers / (divisions.core_cells + divisions.core_layers), M_PI / 8, M_PI / 4);
  // A lens: its corners are wide enough for the rings' cells, and lie on the radii to the corners of the circle.
  constexpr double bulge_ends = 0.1, bulge = 0.45, corner = 0.6;
  const double core_x = corner * std::cos(end) / (1 - bulge_ends), core_z = corner * std::sin(end) / (1 - bulge);
  const std::array<double, 2> inner{core_x * xi * (1 - bulge_ends * eta * eta), core_z * eta * (1 - bulge * xi * xi)};
  std::array<double, 2> outer{};
  if (std::abs(node.layer * 2 - divisions.core_layers) == divisions.core_layers) {
    const double angle = (M_PI / 2 - end) * xi;
    outer = {std::sin(angle), eta * std::cos(angle)};
  } else {
    outer = {xi * std::cos(end * eta), std::sin(end * eta)};
  }
  const double share = static_cast<double>(node.ring) / divisions.rings;
  return {radius * ((1 - share) * inner[0] + share * outer[0]), radius * ((1 - share) * inner[1] + share * outer[1])};
}

CenterlinePoint centerline(const SpatulaShape& shape, double length) {
  const double r = shape.fillet_radius;
  const double angle = std::min(length / r, shape.inclination * M_PI / 180);
  const double beyond = length - r * angle;
  const double s = std::sin(angle), c = std::cos(angle);
  const double start = shape.gap + shape.rear_thickness / 2;
  return {-r * s - beyond * c, start + r * (1 - c) + beyond * s, s, c};
}

double roundness(const SpatulaShape& shape, double length) {
  const double s = std::min(length / shape.transition_length, 1.0);
  return s * s * s * (10 - 15 * s + 6 * s * s);
}

double station_length(const SpatulaShape& shape, const SpatulaDivisions& divisions, int station) {
  if (station <= divisions.shaft)
    return shape.transition_length + shape.shaft_length * (1 - static_cast<double>(station) / divisions.shaft);
  const double share = 1 - static_cast<double>(station - divisions.shaft) / divisions.transition;
  const double g = shape.growth;
  return shape.transition_length * (g > 1 ? (std::pow(g, share) - 1) / (g - 1) : share);
}

}  // namespace ixos
