#include "scene/read/mesh_refinement.hpp"

#include "parameters/one_of.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

const char* const directions = "Directions";

const Options<RefinedRegion>& options() {
  static const Options<RefinedRegion> all =
      Options<RefinedRegion>()
          .add("Levels", &RefinedRegion::levels,
               "Number of times that the edges of the cells in the region are halved. Each level makes 4 cells of one, "
               "in 3D 8.",
               between(1, 30))
          .add("Lower", &RefinedRegion::lower, "A box: its smallest coordinates [L0]. If empty, there is no bound.",
               any_number())
          .add("Upper", &RefinedRegion::upper, "A box: its largest coordinates [L0]. If empty, there is no bound.",
               any_number())
          .add("Sphere Radius", &RefinedRegion::sphere_radius,
               "The inside of a sphere (a circle in 2D): its radius [L0]. With 0, there is no sphere.", at_least(0))
          .add("Sphere Center", &RefinedRegion::sphere_center, "Centre of the sphere [L0]. If empty, it is the origin.",
               any_number())
          .add("Side Set", &RefinedRegion::side_set,
               "Side set of the generator or the file: cells near its sides are split. If empty, there is no side set.")
          .add("Distance", &RefinedRegion::distance,
               "Distance up to which a cell is near a side [L0], measured between the boxes around both.", at_least(0));
  return all;
}

}  // namespace

void declare_refinement(Teuchos::ParameterList& list) {
  options().declare(list);
  list.set(directions, "all",
           "Directions along which Ixos splits cells. It halves a cell along the axes of the cell that are closest to "
           "them. A thin film needs no more cells through its thickness.",
           one_of({"all", "x", "y", "z", "xy", "xz", "yz"}));
}

std::vector<NamedRegion> refined_regions(const SceneNode& refine) {
  std::vector<NamedRegion> regions;
  for (const SceneNode& own : refine.sublists()) {
    NamedRegion region{own.path(), options().read(own)};
    if (const std::string& axes = own.text(directions); axes != "all") region.region.directions = axes;
    regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace ixos
