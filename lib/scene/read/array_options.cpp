#include "scene/read/array_options.hpp"

#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

const Options<ArrayGrid>& grid_options() {
  static const Options<ArrayGrid> options =
      Options<ArrayGrid>()
          .add("Counts", &ArrayGrid::counts,
               "Number of copies along x and y in 3D, along x in 2D [-]: one number for each of these directions.",
               between(1, 30000))
          .add("Spacing", &ArrayGrid::spacing, "Distance of neighbours along these directions [L0].", greater_than(0))
          .add("Stagger", &ArrayGrid::stagger,
               "3D only: shift of every second row along x, as a part of the spacing; 0.5 with a spacing of rows of "
               "0.866 makes triangles [-].",
               at_least_and_less_than(0, 1));
  return options;
}

const Options<ArrayRing>& ring_options() {
  static const Options<ArrayRing> options =
      Options<ArrayRing>()
          .add("Count", &ArrayRing::count, "Number of copies [-].", between(1, 1000000))
          .add("Radius", &ArrayRing::radius, "Radius of the ring around the origin, in the plane of x and y [L0].",
               greater_than(0))
          .add("Turn", &ArrayRing::turn, "Whether copies turn with their place about the last axis.");
  return options;
}

const Options<ArrayPlaces>& table_options() {
  static const Options<ArrayPlaces> options =
      Options<ArrayPlaces>()
          .add("Places", &ArrayPlaces::places,
               "Translations of the copies, one after the other: as many numbers each as the mesh has dimensions [L0].",
               any_number())
          .add("Angles", &ArrayPlaces::angles,
               "Angles by which the copies turn about the last axis, in 2D about z [degrees]. If empty, none turns.",
               any_number())
          .add("Scales", &ArrayPlaces::scales, "Factors of the copies' sizes [-]. If empty, all are 1.",
               greater_than(0));
  return options;
}

const Options<ArrayDisorder>& disorder_options() {
  static const Options<ArrayDisorder> options =
      Options<ArrayDisorder>()
          .add("Seed", &ArrayDisorder::seed,
               "Number from which all random numbers follow, with the number of the copy alone: they are the same on "
               "any machine and any number of ranks [-].",
               at_least(0))
          .choose("Distribution", &ArrayDisorder::normal, {{"Uniform", false}, {"Normal", true}},
                  "Uniform: up to the amounts below on both sides. Normal: the amounts are standard deviations.")
          .add("Place", &ArrayDisorder::place,
               "Amount of the shift along each direction, the last one the height [L0]. If empty, none.", at_least(0))
          .add("Angle", &ArrayDisorder::angle, "Amount of the turn about the last axis, in 2D about z [degrees].",
               at_least(0))
          .add("Inclination", &ArrayDisorder::inclination,
               "3D only: amount of the turn about an axis across the last one, in a random direction [degrees].",
               at_least(0))
          .add("Scale", &ArrayDisorder::scale, "Amount of the change of size, as a part of it [-].",
               at_least_and_less_than(0, 1))
          .free_form("Parameters", &ArrayDisorder::parameters,
                     "Amounts for real numbers of the part's list, relative to them, in lists of the same names: the "
                     "entry Pad Length in a list Spatula.");
  return options;
}

const Options<ArrayOptions>& options() {
  static const Options<ArrayOptions> all =
      Options<ArrayOptions>()
          .choose_list("Layout", &ArrayOptions::layout,
                       {{"Once", ArrayLayout::Once},
                        {"Grid", ArrayLayout::Grid},
                        {"Ring", ArrayLayout::Ring},
                        {"Table", ArrayLayout::Table}},
                       "Where the copies of the part stand. Once: there is one, without a number.")
          .add("Point", &ArrayOptions::point,
               "Point of the part about which its copies are scaled, inclined and turned, for example the root of a "
               "pillar [L0]. If empty, it is the origin.",
               any_number())
          .sublist("Grid", &ArrayOptions::grid, grid_options(),
                   "A grid of copies around the origin. They are counted along x first.")
          .sublist("Ring", &ArrayOptions::ring, ring_options(), "Copies on a ring.")
          .sublist("Table", &ArrayOptions::table, table_options(), "Copies at given places.")
          .sublist("Disorder", &ArrayOptions::disorder, disorder_options(),
                   "Random differences of the copies. A copy is scaled about the Point, then inclined, turned and "
                   "shifted.");
  return all;
}

}  // namespace

void declare_array(Teuchos::ParameterList& part) { options().declare(part); }

ArrayOptions read_array(const SceneNode& part) { return options().read(part); }

}  // namespace ixos
