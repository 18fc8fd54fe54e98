/// Where surfaces begin to feel each other: the change of a law's traction over faces.
#pragma once
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "adapt/split_mesh.hpp"

namespace ixos {

class GapLaw;

/// Returns the largest attraction of a law [E0]; 0 for a law that attracts nowhere.
double strength(const GapLaw& law);

/// Returns the largest change of the traction between two gaps in a range, over the largest attraction of the law.
/// Pressure counts up to that attraction: where surfaces are pressed together there is no front. 0 for a law that
/// attracts nowhere.
double traction_change(const GapLaw& law, double least, double largest);

/// The gaps of a surface in a state of a split mesh. A face of a whole cell, or of a part, old or new, has the gaps of
/// the faces in it; a part of a face of the mesh those between its corners.
class Front {
 public:
  /// `gaps`: by node of the mesh, NaN away from the surface [L0]. The mesh must outlive the front.
  Front(const SplitMesh& mesh, const std::string& side_set, std::shared_ptr<const GapLaw> law,
        std::vector<double> gaps);

  /// Returns the largest traction_change() of the cell's faces on the surface; 0 if it has none. The local cohesive
  /// zone is as many faces long as this number goes into 1.
  double change(const TreeCell& cell) const;
  /// Returns the cells of the mesh with a face on the surface, by their numbers in the tree; a cell may come twice.
  const std::vector<int>& leaves() const { return leaves_; }

 private:
  struct Range {
    double least = std::numeric_limits<double>::infinity(), largest = -std::numeric_limits<double>::infinity();
    void add(double gap);
  };
  using Face = std::pair<int, int>;  ///< a cell of the tree; twice the axis across the face, and the end

  void add(const Side& side);
  Range range(const TreeCell& cell, int face) const;

  const SplitMesh& mesh_;
  std::shared_ptr<const GapLaw> law_;
  std::vector<double> gaps_;  ///< zero away from the surface
  std::map<Face, Range> ranges_;
  std::vector<int> leaves_;
};

}  // namespace ixos
