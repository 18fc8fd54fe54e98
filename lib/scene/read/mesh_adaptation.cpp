#include "scene/read/mesh_adaptation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "adapt/front.hpp"
#include "base/error.hpp"
#include "interaction/gap_law.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/selection.hpp"
#include "mesh/splitting/refine.hpp"
#include "parameters/one_of.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

const char* const name = "Adapt";
const char* const directions = "Directions";

const Options<AdaptOptions>& options() {
  static const Options<AdaptOptions> all =
      Options<AdaptOptions>()
          .add("Levels", &AdaptOptions::levels,
               "Number of times that the edge of a cell may be halved, those of Refine included. With 0, the mesh "
               "stays.",
               between(0, most_adapt_levels))
          .add("Part", &AdaptOptions::part,
               "Largest change of the traction over a face, as part of the law's strength: a face is at most this part "
               "of the local cohesive zone. Larger ones are halved [-].",
               between(least_adapt_part, 1.0))
          .add("Strain", &AdaptOptions::strain,
               "Largest jump of the displacement gradient at the corners of a cell, between the cell and the mean of "
               "those around the corner [-]. With 0, cells are split for the faces alone.",
               at_least(0))
          .add("Keep", &AdaptOptions::keep,
               "Part of a bound above which cells that are split stay split. It keeps meshes from changing to and fro "
               "[-].",
               between(0.05, 0.95))
          .add("Interval", &AdaptOptions::interval,
               "Number of steps from one look for cells that are finer than needed to the next. Ixos looks for cells "
               "that are too coarse after each step, and takes that step again on the finer mesh.",
               at_least(1))
          .add("Budget", &AdaptOptions::budget,
               "Sum of the changes of energy by coarser cells, over the largest energy of the run, up to which cells "
               "are "
               "joined again [-].",
               at_least(0));
  return all;
}

/// Returns whether a condition holds for some side of the pair's surfaces.
template <class Condition>
bool has_side(const Mesh& mesh, const SceneInteraction& interaction, const Condition& condition) {
  for (const std::string& surface : {interaction.side_set, interaction.primary}) {
    const std::vector<Side>& sides = side_set_named(mesh, surface).sides;
    if (std::any_of(sides.begin(), sides.end(), condition)) return true;
  }
  return false;
}

}  // namespace

void declare_adaptation(Teuchos::ParameterList& mesh) {
  Teuchos::ParameterList& list =
      mesh.sublist(name, false,
                   "A mesh that follows the front: during the run, cells are split where surfaces begin to feel each "
                   "other, and joined again where they no longer do.");
  options().declare(list);
  list.set(directions, "all",
           "Directions along which Ixos splits cells. It halves a cell along the axes of the cell that are closest to "
           "them.",
           one_of({"all", "x", "y", "z", "xy", "xz", "yz"}));
}

AdaptOptions read_adaptation(const SceneNode& scene, const std::vector<SceneInteraction>& interactions) {
  const SceneNode mesh = scene.sublist("Mesh"), node = mesh.sublist(name);
  AdaptOptions result = options().read(node);
  if (const std::string& axes = node.text(directions); axes != "all") result.directions = axes;
  if (!result.on()) return result;
  const auto refuse = [&](const std::string& what, const std::string& way) {
    throw InputError(fmt::format("{}: a mesh that follows the front does not go with {}; {}", node.path(), what, way));
  };
  const std::string off = "set Levels to 0, or use Mesh/Refine";
  for (const char* list : {"Ties", "Periodic"})
    if (!mesh.sublist(list).sublists().empty()) refuse(mesh.path_of(list), off);
  bool has_front = result.strain > 0;
  for (const SceneInteraction& interaction : interactions) {
    const std::string path = interaction.node.path();
    if (interaction.is_with_itself()) refuse(path + ", a surface that interacts with itself", off);
    if (interaction.is_pair() && interaction.passes == Passes::DoubleIntegral)
      refuse(path + "/Passes Double Integral, which has no gap", "choose \"Two\"");
    if (interaction.element == ContactElement::Q1CH) refuse(path + "/Contact Element Q1CH", "choose Q1C4");
    if (!interaction.factor_field.empty()) refuse(path + "/Factor Field", "give a Factor");
    has_front = has_front || strength(*interaction.law) > 0;
  }
  if (!has_front)
    throw InputError(
        fmt::format("{}: nothing tells where cells are split: no interaction attracts, and Strain is 0", node.path()));
  return result;
}

void check_adaptation(const AdaptOptions& options, const std::vector<SceneInteraction>& interactions,
                      const Mesh& mesh) {
  if (!options.on()) return;
  if (mesh.dimension == 2 && options.directions.find('z') != std::string::npos)
    throw InputError("Mesh/Adapt/Directions: \"z\" is no axis of a mesh of two dimensions; \"x\" and \"y\" are");
  if (!options.directions.empty() && has_simplices(mesh))
    throw InputError("Mesh/Adapt/Directions: triangles and tetrahedra have no axes; choose \"all\"");
  const auto is_triangle = [&](const Side& side) { return count_of(corners_of(mesh, side)) == 3; };
  const auto has_corners_alone = [&](const Side& side) { return nodes_of_side(mesh, side).size() <= 4; };
  for (const SceneInteraction& interaction : interactions)
    if (mesh.dimension == 3 && interaction.is_pair() && interaction.friction.type != FrictionType::None &&
        has_side(mesh, interaction, is_triangle))
      throw InputError(
          fmt::format("{}/Friction: what slides on triangles does not go to another mesh, and Mesh/Adapt changes the "
                      "mesh; set Type "
                      "to None, Levels to 0, or use hexahedra",
                      interaction.node.path()));
  if (mesh.dimension == 2) return;  // the ends of sides are corners of their neighbours, whatever their sizes
  for (const SceneInteraction& interaction : interactions)
    if (interaction.is_pair() && interaction.smoothing != Smoothing::None &&
        has_side(mesh, interaction, has_corners_alone))
      throw InputError(
          fmt::format("{}/Smoothing: curved patches do not close where cells of two sizes meet, and Mesh/Adapt makes "
                      "such cells; choose \"None\", or quadratic cells",
                      interaction.node.path()));
}

}  // namespace ixos
