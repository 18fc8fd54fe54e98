/// The mesh that a scene asks for.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include <string>

#include "mesh/generators/entry.hpp"
#include "mesh/splitting/refine.hpp"
#include "units/unit_system.hpp"

namespace ixos {

/// The entry of the list "Mesh" that gives the meaning of a mesh of two dimensions, and its value for a body of
/// revolution.
constexpr const char* geometry_choice = "Geometry";
constexpr const char* axisymmetric_geometry = "Axisymmetric";

/// The entry of the list "Mesh" that gives the order of the cells.
constexpr const char* cell_order = "Cell Order";

/// Returns whether a list "Mesh" chooses a body of revolution.
bool is_axisymmetric(const Teuchos::ParameterList& mesh);

/// Lets gmsh make the meshes of the drawings in a validated "Mesh" list, so that scene_mesh() finds them on all ranks.
/// For the first rank: gmsh runs once. Throws as drawn_mesh() does.
void prepare_drawings(Teuchos::ParameterList list, const std::string& scene_folder);

/// Makes the mesh of a validated "Mesh" list, with its order of cells and its map; it has passed check_cells(). Looks
/// for a mesh file in the working folder, then in `scene_folder`. `bubbles`: quadratic cells get the nodes of those
/// with bubbles, see raised_type(). Throws InputError with the list path.
/// `splitting`: how cells are split beside the list's own regions.
Mesh scene_mesh(Teuchos::ParameterList& list, const std::string& scene_folder, bool bubbles = false,
                Splitting splitting = {});

/// Checks a mesh that a program provides (check_arrays(), repeated cells, check_cells()), and applies order, map and
/// sets of a validated "Mesh" list. Throws InputError with the list path.
Mesh scene_mesh(const Teuchos::ParameterList& list, Mesh given, bool bubbles = false, Splitting splitting = {});

/// Returns whether a scene needs cells with bubbles where there are any: for the formulation Mean Dilatation, or for
/// the lumped mass of explicit schemes. `scene` need not be complete.
bool needs_bubbles(const Teuchos::ParameterList& scene);

/// Returns the user's scene with "Given" as its mesh, of that dimension, in place of any other; its "Mesh/Sets" stay.
/// An axisymmetric mesh sets the "Geometry", otherwise the scene's stays.
Teuchos::ParameterList with_given_mesh(const Teuchos::ParameterList& scene, int dimension, bool axisymmetric);

/// Returns "the mesh spans 30 x 40 L0 = 30 nm x 40 nm" for a mesh from outside, in which a wrong unit of length
/// shows; the same for each part from outside; an empty text for others.
std::string size_note(const Teuchos::ParameterList& list, const Mesh& mesh, const UnitSystem& units);

/// Returns whether the mesh that a list chooses, "Mesh" or that of a part, comes from a file or a program, not from a
/// generator.
bool is_from_outside(const SceneNode& list);

/// Returns the catalogue of meshes; its choice is "Type".
const Catalogue<MeshEntry>& meshes();

}  // namespace ixos
