#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/generators/spatula.hpp"

namespace ixos {
namespace {

template <class T>
void require(bool holds, const char* name, T value, const std::string& allowed) {
  if (!holds) throw InputError(fmt::format("{} {} must be {}", name, value, allowed));
}

void check_lengths(const SpatulaShape& s) {
  const auto positive = [](const char* name, double value) {
    require(value > 0 && std::isfinite(value), name, value, "positive");
  };
  positive("pad length", s.pad_length);
  positive("neck width", s.neck_width);
  require(s.tip_width >= s.neck_width && std::isfinite(s.tip_width), "tip width", s.tip_width,
          fmt::format("at least the neck width, {}", s.neck_width));
  positive("widening length", s.widening_length);
  positive("tip length", s.tip_length);
  require(s.widening_length + s.tip_length <= s.pad_length, "tip length", s.tip_length,
          fmt::format("at most the pad length less the widening length, {}", s.pad_length - s.widening_length));
  positive("rear thickness", s.rear_thickness);
  positive("tip thickness", s.tip_thickness);
  positive("shaft diameter", s.shaft_diameter);
  positive("shaft length", s.shaft_length);
  positive("gap", s.gap);
}

void check_bend(const SpatulaShape& s) {
  require(s.inclination > 0 && s.inclination <= 90, "inclination", s.inclination, "greater than 0 and at most 90");
  const double half = std::max(s.shaft_diameter, s.rear_thickness) / 2;
  require(s.fillet_radius > half && std::isfinite(s.fillet_radius), "fillet radius", s.fillet_radius,
          fmt::format("greater than half the thickness of shaft and pad, {}", half));
  const double arc = s.fillet_radius * s.inclination * M_PI / 180;
  require(s.transition_length >= arc && std::isfinite(s.transition_length), "transition length", s.transition_length,
          fmt::format("at least the length of the fillet, {:.6g}", arc));
}

void check_counts(const SpatulaShape& s) {
  const auto in = [](int lower, int value, int upper) { return value >= lower && value <= upper; };
  require(in(4, s.core_cells, 1000) && s.core_cells % 2 == 0, "core cells", s.core_cells,
          "even and between 4 and 1000");
  require(in(1, s.core_layers, 100), "core layers", s.core_layers, "between 1 and 100");
  require(in(1, s.rings, 100), "rings", s.rings, "between 1 and 100");
  require(in(1, s.tip_rows, s.core_cells / 2 - 1), "tip rows", s.tip_rows,
          fmt::format("between 1 and half the core cells less 1, {}", s.core_cells / 2 - 1));
  require(s.stations == 0 || in(3, s.stations, 100000), "stations", s.stations, "0, or between 3 and 100000");
  require(in(200, s.target_cells, 20000000), "target cells", s.target_cells, "between 200 and 20000000");
  require(s.growth >= 1 && s.growth <= 100, "growth", s.growth, "between 1 and 100");
  require(s.layer_ratio >= 1 && s.layer_ratio <= 100, "layer ratio", s.layer_ratio, "between 1 and 100");
}

/// Reduces the cells in a section for small targets, in the proportions of the section given, so that stations remain
/// for a mesh of 50,000 cells or less.
void coarsen_section(const SpatulaShape& shape, SpatulaDivisions& d) {
  const double scale = std::sqrt(shape.target_cells / 50000.0);
  if (scale >= 1) return;
  d.core_cells = std::max(4, 2 * static_cast<int>(std::lround(scale * shape.core_cells / 2)));
  if (shape.target_cells < 3000) d.rings = 1;
  d.tip_rows = std::clamp(static_cast<int>(std::lround(scale * shape.tip_rows)), 1, d.core_cells / 2 - 1);
}

/// Returns the cells of the tip beyond those of the sweep.
int tip_cells(const SpatulaDivisions& d) {
  return (d.core_cells - 2 * d.tip_rows) * (d.tip_rows * (d.core_layers + 2 * d.rings) + d.rings * d.core_layers);
}

}  // namespace

int SpatulaDivisions::cells() const { return stations() * section_cells() + tip_cells(*this); }

SpatulaDivisions spatula_divisions(const SpatulaShape& shape) {
  check_lengths(shape);
  check_bend(shape);
  check_counts(shape);
  SpatulaDivisions d{shape.core_cells, shape.core_layers, shape.rings, shape.tip_rows, 0, 0, 0};
  int stations = shape.stations;
  if (stations == 0) {
    coarsen_section(shape, d);
    const double left = shape.target_cells - tip_cells(d);
    stations = std::max(3, static_cast<int>(std::lround(left / d.section_cells())));
  }
  // Lengths in units of the pad's cells; these grow linearly along the transition.
  const double g = shape.growth;
  const double transition = shape.transition_length * (g > 1 ? std::log(g) / (g - 1) : 1.0);
  const double shaft = shape.shaft_length / g;
  const double per_length = stations / (shape.pad_length + transition + shaft);
  d.transition = std::max(1, static_cast<int>(std::lround(per_length * transition)));
  d.shaft = std::max(1, static_cast<int>(std::lround(per_length * shaft)));
  while (d.transition + d.shaft > stations - 1) --(d.shaft > d.transition ? d.shaft : d.transition);
  d.pad = stations - d.transition - d.shaft;
  if (1.0 * stations * d.section_cells() > 5e7)
    throw InputError(fmt::format("stations {} make {:.3g} cells; at most 5e7 are allowed", stations,
                                 1.0 * stations * d.section_cells()));
  return d;
}

}  // namespace ixos
