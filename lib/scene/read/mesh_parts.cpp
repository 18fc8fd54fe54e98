#include "scene/read/mesh_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "interaction/direction.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/cell_place.hpp"
#include "mesh/generators/given.hpp"
#include "mesh/joined_parts.hpp"
#include "mesh/merged_parts.hpp"
#include "mesh/name_pattern.hpp"
#include "mesh/overlaps.hpp"
#include "mesh/placement.hpp"
#include "mesh/quality.hpp"
#include "mesh/soundness.hpp"
#include "mesh/tied_nodes.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"
#include "scene/read/array_options.hpp"
#include "scene/read/mesh_array.hpp"
#include "scene/read/mesh_map.hpp"
#include "scene/read/mesh_sets.hpp"

namespace ixos {
#define ENTRY(name) MeshEntry name();
#include "scene/read/mesh_entries.def"
#undef ENTRY

namespace {

struct Place {
  std::vector<double> translation;
  double angle = 0;
  std::vector<double> axis, point;
};

const Options<Place>& place_options() {
  static const Options<Place> options =
      Options<Place>()
          .add("Translation", &Place::translation,
               "Translation of the part, after its rotation [L0]. If empty, the part stays.", any_number())
          .add("Rotation Angle", &Place::angle,
               "Angle by which the part turns, counter-clockwise as seen from the tip of the axis [degrees].",
               any_number())
          .add("Rotation Axis", &Place::axis,
               "3D only: direction of the axis about which the part turns, of any length [-]. If empty, it is z.",
               any_number())
          .add("Rotation Point", &Place::point,
               "Point about which the part turns, in the coordinates of the part's own list [L0]. If empty, it is the "
               "origin.",
               any_number());
  return options;
}

void declare_part(Teuchos::ParameterList& part) {
  part_meshes().declare(part);
  place_options().declare(part);
  declare_map(part.sublist("Map", false, "Formulas that move the nodes of the part before it is rotated."));
  declare_set(part.sublist("Sets", false,
                           "Additional sets of the part, selected by region before it is rotated. Their names get the "
                           "prefix of the part.")
                  .sublist(any_name));
}

Placement placement(const SceneNode& part, int dimension) {
  const Place place = place_options().read(part);
  const auto d = static_cast<std::size_t>(dimension);
  if (dimension == 2 && !place.axis.empty())
    part.refuse("Rotation Axis", "a part of two dimensions turns about z; leave it out");
  Placement result;
  result.angle = place.angle;
  if (dimension == 3) result.axis = unit_vector(part, "Rotation Axis", d, result.axis);
  result.point = place_of(part, "Rotation Point", d);
  result.translation = place_of(part, "Translation", d);
  return result;
}

Mesh part_mesh(const SceneNode& part, int order) {
  Mesh mesh = mapped_mesh(part_meshes(), part, order);
  at(part.path(), [&] { check_cells(mesh); });
  add_sets(part.sublist("Sets"), mesh);
  move_nodes(placement(part, mesh.dimension), mesh);
  return mesh;
}

const char* const merge_name = "Merge";

/// Parts that are tied or merged may reach a little into each other.
void refuse_overlaps(const SceneNode& node, const std::vector<MeshPart>& parts) {
  constexpr double depth = 0.2;
  std::vector<const Mesh*> meshes;
  meshes.reserve(parts.size());
  for (const MeshPart& part : parts) meshes.push_back(&part.mesh);
  if (const auto overlap = find_overlap(meshes, depth))
    throw InputError(fmt::format("{}: the parts \"{}\" and \"{}\" overlap at {}; put them farther apart", node.path(),
                                 parts[overlap->first].name, parts[overlap->second].name,
                                 point_in_words(overlap->place, meshes.front()->dimension)));
}

Mesh parts_of_order(const SceneNode& node, int order) {
  std::vector<MeshPart> parts;
  const bool repeats = node.name() == array_mesh_name;
  for (const SceneNode& part : node.sublists()) {
    const auto make = [order](const SceneNode& list) { return part_mesh(list, order); };
    parts.push_back({part.name(), repeats ? array_of(part, make) : make(part)});
  }
  if (repeats) refuse_overlaps(node, parts);
  Mesh mesh = joined_parts(parts);
  const double tolerance = node.number(merge_name);
  if (tolerance > 0) at(node.path_of(merge_name), [&] { merge_parts(parts, tolerance, mesh); });
  return mesh;
}

}  // namespace

const char* const parts_mesh_name = "Parts";
const char* const array_mesh_name = "Array";

bool has_parts(const std::string& name) { return name == parts_mesh_name || name == array_mesh_name; }

namespace {

MeshEntry mesh_of_parts() {
  MeshEntry entry;
  entry.parameters.set(merge_name, 0.0,
                       "Distance up to which nodes of different parts become one [L0]: parts that share a face are "
                       "bonded, and the faces must match. 0: parts that touch are not connected.",
                       at_least(0));
  entry.make = [](const SceneNode& node) { return parts_of_order(node, 1); };
  entry.make_quadratic = [](const SceneNode& node) { return parts_of_order(node, 2); };
  return entry;
}

}  // namespace

MeshEntry parts_mesh() {
  MeshEntry entry = mesh_of_parts();
  entry.name = parts_mesh_name;
  entry.sentence =
      "Several bodies in one mesh. Each list makes one part with its own mesh. The names of its "
      "blocks and sets begin with its name and \"_\": the part \"left\" has the block \"left_body\" and the side set "
      "\"left_surface\". Parts that touch are not connected, unless Merge bonds them. A part's name has letters, "
      "digits, \"_\" and \"-\".";
  declare_part(entry.parameters.sublist(any_name, false, "A part: its mesh, and where it stands."));
  return entry;
}

MeshEntry array_mesh() {
  MeshEntry entry = mesh_of_parts();
  entry.name = array_mesh_name;
  entry.sentence =
      "Parts as those of Parts, each of which may be repeated. Copies are counted from 1: the part \"hair\" "
      "has "
      "the block \"hair_body\" of all copies, the side set \"hair_pad\" of all, and \"hair_17_pad\" of the copy 17. A "
      "name of a set with \"*\" stands for all sets that it matches: \"hair_1*_pad\". Parts and copies must not "
      "overlap.";
  Teuchos::ParameterList& part =
      entry.parameters.sublist(any_name, false, "A part: its mesh, where it stands, and where its copies do.");
  declare_part(part);
  declare_array(part);
  return entry;
}

const Catalogue<MeshEntry>& part_meshes() {
#define ENTRY(name) name(),
  static const Catalogue<MeshEntry> catalogue = [] {
    std::vector<MeshEntry> entries{
#include "scene/read/mesh_entries.def"
    };
    const auto given = [](const MeshEntry& entry) { return entry.name == given_mesh_name; };
    entries.erase(std::remove_if(entries.begin(), entries.end(), given), entries.end());
    return Catalogue<MeshEntry>("Type", "Selects the part's mesh generator, or the format of its mesh file.", entries);
  }();
#undef ENTRY
  return catalogue;
}

namespace {

void prepare(const SceneNode& node, int order, Mesh& mesh) {
  if (order == 2) at(node.path_of("Cell Order"), [&] { raise_order(mesh); });
  at(node.path(), [&] {
    require_one_order(mesh);
    refuse_split_faces(mesh);
    require_shared_middles(mesh);
  });
}

void split_and_map(const SceneNode& node, int order, const Splitting& splitting, Mesh& mesh) {
  if (!splitting.regions.empty()) add_pattern_sets(set_patterns(node.sublist("Refine").list()), mesh);
  at(node.path_of(splitting.regions.empty() ? "Adapt" : "Refine"), [&] { split(mesh, splitting, order); });
  map_nodes(node.sublist("Map"), mesh);
  place_bubbles(mesh);
  place_tied_nodes(mesh);
}

int order_of(const Mesh& mesh) {
  return std::any_of(mesh.blocks.begin(), mesh.blocks.end(), [](const auto& block) { return is_quadratic(block.type); })
             ? 2
             : 1;
}

}  // namespace

Mesh mapped_mesh(const Catalogue<MeshEntry>& catalogue, const SceneNode& node, int order, const Splitting& splitting) {
  const MeshEntry& chosen = catalogue.chosen(node);
  // Parts of a curved cell lie on a curve that its quadratic form knows.
  const bool curved = chosen.make_quadratic && (order == 2 || splitting.any());
  Mesh mesh = [&] {
    if (!curved) return catalogue.make(node);
    const SceneNode own = node.sublist(chosen.name);
    return at(own.path(), [&] { return chosen.make_quadratic(own); });
  }();
  prepare(node, order, mesh);
  split_and_map(node, curved ? order : order_of(mesh), splitting, mesh);
  return mesh;
}

void apply_order_and_map(const SceneNode& node, int order, const Splitting& splitting, Mesh& mesh) {
  prepare(node, order, mesh);
  split_and_map(node, order_of(mesh), splitting, mesh);
}

std::vector<SceneNode> part_lists(const SceneNode& mesh) {
  if (const std::string& type = mesh.text("Type"); has_parts(type)) return mesh.sublist(type).sublists();
  return {mesh};
}

const SceneNode& list_of(const ElementBlock& block, const std::vector<SceneNode>& lists) {
  const auto own = [&block](const SceneNode& list) { return is_in_part(list.name(), block.name); };
  const auto found = std::find_if(lists.begin(), lists.end(), own);
  return found == lists.end() ? lists.front() : *found;
}

}  // namespace ixos
