/// Parts of a mesh whose cells are to be split.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Cells that meet all conditions that are given are halved `levels` times. A cell meets a condition if the smallest
/// axis-parallel box around its corners does. Lists have D coordinates, or are empty.
struct RefinedRegion {
  int levels = 1;                        ///< halvings of the cells' edges, at least 1
  std::string directions{};              ///< such as "xy": a cell is split along its axes closest to these; empty: all
  std::vector<double> lower{}, upper{};  ///< an axis-parallel box: its corners [L0]; empty: no bound
  double sphere_radius = 0;              ///< a ball (2D: a disk): its radius [L0]; 0: no ball
  std::vector<double> sphere_center{};   ///< its centre [L0]; empty: the origin
  std::string side_set{};                ///< cells near these sides; empty: anywhere
  double distance = 0;                   ///< from the box around a side up to which a cell is near [L0]
};

/// An axis-parallel box.
struct CornerBox {
  std::array<double, 3> lower{}, upper{};  ///< in 2D the third coordinate is 0 [L0]
};

/// Returns the box around nodes of the mesh.
CornerBox box_around(const Mesh& mesh, const std::vector<int>& nodes);

/// Returns whether the axis that is closest to a direction is one of those named, such as "xy"; if none are, whether it
/// is any.
bool is_along(const std::array<double, 3>& direction, const std::string& axes);

/// Tells which boxes meet a region's conditions.
class RegionSearch {
 public:
  /// Throws InputError, with the name of a scene's parameter, if a list has another number of coordinates than the
  /// mesh, a direction is no axis of it, the side set does not exist, or nothing tells where the region is.
  RegionSearch(const Mesh& mesh, const RefinedRegion& region);
  ~RegionSearch();
  RegionSearch(RegionSearch&&) noexcept;

  bool meets(const CornerBox& box) const;
  int levels() const { return region_.levels; }
  /// Returns whether cells are split along an axis that has this direction, of any length.
  bool splits_along(const std::array<double, 3>& direction) const;
  bool splits_all() const { return region_.directions.empty(); }

 private:
  struct Sides;
  RefinedRegion region_;
  std::unique_ptr<const Sides> sides_;  ///< null without a side set
};

}  // namespace ixos
