/// Where the nodes of a spatula's pad lie, seen from above.
#pragma once
#include <array>

#include "mesh/generators/spatula.hpp"

namespace ixos {

/// The pad as a core of columns along x and a band of `tip_rows` cells that follows the outline along both sides and
/// around the tip. The band ends at the outline, or, by `inset` of the rim's width, short of it: 0 at the outermost
/// ring of a section, 1 at the section's core.
class SpatulaPad {
 public:
  using Point = std::array<double, 2>;  ///< x and y [L0]

  SpatulaPad(const SpatulaShape& shape, const SpatulaDivisions& divisions);

  /// Returns a node of the sweep: `station` from 0 (rear end) to divisions.pad, where the columns outside the core end
  /// on the diagonal at 45 degrees; `column` from 0 (smallest y) to core_cells.
  Point swept(int station, int column, double inset) const;
  /// Returns a node of the rows around the tip: `row` from 0, the last station, to tip_rows, the outline; `column` from
  /// tip_rows to core_cells - tip_rows.
  Point at_tip(int row, int column, double inset) const;

  double thickness(double x) const;  ///< [L0]

 private:
  /// A point of the outline, y >= 0, the direction out of the pad along which the band is measured there, and the
  /// band's depth. On the ellipse at angle t, a point (a cos t, b sin t), that is (cos t, sin t): nearly the normal,
  /// and such lines do not cross within the pad whatever a and b are.
  struct Edge {
    Point point, outward;
    double depth;
  };
  Edge side(double u) const;  ///< u from 0, rear end, to 1, at 45 degrees
  Edge tip(double w) const;   ///< w from 0, at 45 degrees, to 1, the apex
  Point inside(const Edge& edge, double share, double inset) const;
  Point core(double u, double v) const;

  SpatulaShape shape_;
  SpatulaDivisions divisions_;
  double straight_share_;             ///< of the side's stations before the ellipse begins
  double apex_depth_, corner_depth_;  ///< of the band
  double side_length_, tip_length_;   ///< of the outline on either side of the diagonal
};

}  // namespace ixos
