// Meshes from arrays, from files and from the generators of scenes.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>

#include "arrays.hpp"
#include "bindings.hpp"
#include "fem/cell_info.hpp"
#include "io/exodus_mesh.hpp"
#include "io/mesh_file.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/generators/given.hpp"
#include "mesh/joined_parts.hpp"
#include "mesh/merged_parts.hpp"
#include "mesh/node_place.hpp"
#include "mesh/quality.hpp"
#include "mesh/region.hpp"
#include "mesh/tied_nodes.hpp"
#include "scene/read/scene_mesh.hpp"
#include "scene/read/scene_units.hpp"
#include "scene_list.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

using Table = py::array_t<long long, py::array::c_style | py::array::forcecast>;

std::string quoted(const char* what, const std::string& name) { return fmt::format("{} \"{}\"", what, name); }

/// Throws InputError unless the array holds integers in `dimensions` dimensions.
Table integers(const py::object& object, py::ssize_t dimensions, const std::string& place) {
  const auto array = py::array::ensure(object);
  const char kind = kind_of(array);
  if (kind != 'i' && kind != 'u') throw InputError(place + ": an array of integers is needed");
  if (array.ndim() != dimensions)
    throw InputError(fmt::format("{}: the array has {} dimensions; {} are needed", place, array.ndim(), dimensions));
  return Table::ensure(array);
}

/// Returns the numbers as node numbers, where `may_miss`(k) also -1. Throws InputError for one that is no point of the
/// mesh.
template <class MayMiss>
std::vector<int> node_numbers(const Table& table, const Mesh& mesh, const std::string& place, const MayMiss& may_miss) {
  std::vector<int> nodes;
  nodes.reserve(static_cast<std::size_t>(table.size()));
  for (py::ssize_t k = 0; k < table.size(); ++k) {
    const long long node = table.data()[k];
    if ((node < 0 && !(node == -1 && may_miss(k))) || node >= mesh.nodes())
      throw InputError(
          fmt::format("{} has node {}; the points are numbered from 0 to {}", place, node, mesh.nodes() - 1));
    nodes.push_back(static_cast<int>(node));
  }
  return nodes;
}
std::vector<int> node_numbers(const Table& table, const Mesh& mesh, const std::string& place) {
  return node_numbers(table, mesh, place, [](py::ssize_t) { return false; });
}

/// `cells`: an array, or a list with one for each type of cells.
void add_block(Mesh& mesh, const std::string& name, const py::object& cells) {
  if (py::isinstance<py::list>(cells) && py::len(cells) > 0 && py::isinstance<py::array>(cells[py::int_(0)])) {
    for (const py::handle& part : cells) add_block(mesh, name, py::reinterpret_borrow<py::object>(part));
    return;
  }
  const std::string place = quoted("block", name);
  const Table table = integers(cells, 2, place);
  const CellInfo* info = cell_with(mesh.dimension, static_cast<int>(table.shape(1)));
  if (info == nullptr)
    throw InputError(fmt::format("{}: its cells have {} nodes; in {} dimensions cells have {}", place, table.shape(1),
                                 mesh.dimension,
                                 mesh.dimension == 2 ? "3, 4, 6, 7 or 9" : "4, 5, 6, 8, 10, 14, 15, 18, 19, 21 or 27"));
  mesh.blocks.push_back({name, info->type, node_numbers(table, mesh, place)});
}

void add_node_set(Mesh& mesh, const std::string& name, const py::object& nodes) {
  const std::string place = quoted("node set", name);
  mesh.node_sets.push_back({name, node_numbers(integers(nodes, 1, place), mesh, place)});
}

/// The sides are rows of their corners, in any order; a triangle beside quadrilaterals has -1 as the last one.
void add_side_set(Mesh& mesh, const std::string& name, const py::object& sides, const std::vector<CellSide>& sorted) {
  const std::string place = quoted("side set", name);
  const Table table = integers(sides, 2, place);
  const auto corners = static_cast<int>(table.shape(1));
  if (mesh.dimension == 2 ? corners != 2 : corners != 3 && corners != 4)
    throw InputError(fmt::format("{}: its sides have {} nodes; in {} dimensions sides have {}", place, corners,
                                 mesh.dimension, mesh.dimension == 2 ? "2" : "3 or 4"));
  const std::vector<int> nodes =
      node_numbers(table, mesh, place, [corners](py::ssize_t k) { return corners == 4 && k % 4 == 3; });
  SideSet set{name, {}};
  for (auto side = nodes.begin(); side != nodes.end(); side += corners) {
    std::vector<int> own(side, side + corners);
    if (own.back() < 0) own.pop_back();
    const auto [first, last] = sides_with(sorted, sorted_corners(own));
    if (first == last)
      throw InputError(fmt::format("{}: no cell has a side with the nodes {}", place, fmt::join(own, ", ")));
    if (last - first > 1)
      throw InputError(fmt::format("{}: two cells share the side with the nodes {}; a side of the boundary is needed",
                                   place, fmt::join(own, ", ")));
    set.sides.push_back(first->side);
  }
  mesh.side_sets.push_back(std::move(set));
}

/// `weights`: those of the nodes that the node follows, by number. `slack`: how far it may be off in its place [L0].
void add_tie(Mesh& mesh, int node, const py::dict& weights, double slack) {
  const std::string place = fmt::format("ties: node {}", node);
  Tie tie{node, {}, {}};
  Vec<3> there{};
  double sum = 0;
  for (const auto& [master, weight] : weights) {
    tie.masters.push_back(master.cast<int>());
    tie.weights.push_back(weight.cast<double>());
    if (tie.masters.back() < 0 || tie.masters.back() >= mesh.nodes())
      throw InputError(fmt::format("{} follows node {}; the points are numbered from 0 to {}", place,
                                   tie.masters.back(), mesh.nodes() - 1));
    there = there + tie.weights.back() * node_place(mesh, tie.masters.back());
    sum += tie.weights.back();
  }
  if (node < 0 || node >= mesh.nodes())
    throw InputError(fmt::format("{}: the points are numbered from 0 to {}", place, mesh.nodes() - 1));
  if (!(std::abs(sum - 1) < 1e-12))
    throw InputError(fmt::format("{}: its weights sum to {:.15g}; the sum must be 1", place, sum));
  tie.in_place = length(there - node_place(mesh, node)) <= slack;
  mesh.ties.push_back(std::move(tie));
}

/// Adds the ties, and what enrichment must know of them: it leaves edges between these nodes as they are.
void add_ties(Mesh& mesh, const py::dict& ties) {
  const double slack = ties.empty() ? 0 : place_tolerance(mesh);
  try {
    for (const auto& [node, weights] : ties) {
      if (!py::isinstance<py::dict>(weights)) throw py::cast_error();
      add_tie(mesh, node.cast<int>(), py::reinterpret_borrow<py::dict>(weights), slack);
    }
  } catch (const py::cast_error&) {
    throw InputError("ties: a dictionary {node: {master: weight}} of whole numbers and numbers is needed");
  }
  resolved_ties(mesh);  // refuses nodes that are tied twice, or follow themselves
  for (const Tie& tie : mesh.ties) {
    mesh.nodes_of_tied_sides.push_back(tie.node);
    mesh.nodes_of_tied_sides.insert(mesh.nodes_of_tied_sides.end(), tie.masters.begin(), tie.masters.end());
    if (tie.in_place && tie.masters.size() == 2)
      mesh.hanging_edges.push_back({tie.masters[0], tie.masters[1], tie.node});
  }
}

py::dict ties(const Mesh& mesh) {
  py::dict result;
  for (const Tie& tie : resolved_ties(mesh)) {
    py::dict weights;
    for (std::size_t k = 0; k < tie.masters.size(); ++k) weights[py::int_(tie.masters[k])] = tie.weights[k];
    result[py::int_(tie.node)] = weights;
  }
  return result;
}

Mesh make_mesh(const py::object& given, const py::dict& blocks, const py::dict& node_sets, const py::dict& side_sets,
               const py::dict& ties) {
  const Numbers points = real_numbers(given, "points");
  if (points.ndim() != 2)
    throw InputError(
        fmt::format("points: the array has {} dimensions; 2 are needed, points x coordinates", points.ndim()));
  Mesh mesh;
  mesh.dimension = static_cast<int>(points.shape(1));
  mesh.coordinates.assign(points.data(), points.data() + points.size());
  if (mesh.dimension != 2 && mesh.dimension != 3)
    throw InputError(fmt::format("points: they have {} coordinates; 2 or 3 are allowed", mesh.dimension));
  for (const auto& [name, cells] : blocks) add_block(mesh, py::str(name), py::reinterpret_borrow<py::object>(cells));
  for (const auto& [name, nodes] : node_sets)
    add_node_set(mesh, py::str(name), py::reinterpret_borrow<py::object>(nodes));
  if (!side_sets.empty()) {
    const std::vector<CellSide> sorted = sorted_sides(mesh);
    for (const auto& [name, sides] : side_sets)
      add_side_set(mesh, py::str(name), py::reinterpret_borrow<py::object>(sides), sorted);
  }
  check_arrays(mesh);
  add_ties(mesh, ties);
  check_cells(mesh);
  return mesh;
}

py::array corners(const Mesh& mesh, const std::vector<Side>& sides) {
  auto most = static_cast<std::size_t>(mesh.dimension);
  for (const Side& side : sides) most = std::max(most, count_of(corners_of(mesh, side)));
  std::vector<int> result;
  for (const Side& side : sides) {
    const SideCorners own = corners_of(mesh, side);
    result.insert(result.end(), own.begin(), own.begin() + static_cast<std::ptrdiff_t>(most));
  }
  return taken(std::move(result), {static_cast<py::ssize_t>(sides.size()), static_cast<py::ssize_t>(most)});
}

/// By name: an array, or a list of arrays if the block has cells of several types.
py::dict blocks(const py::object& self) {
  py::dict result;
  for (const ElementBlock& block : self.cast<const Mesh&>().blocks) {
    const py::str name(block.name);
    py::object cells = view(block.nodes.data(), {block.cells(), nodes_per_cell(block.type)}, self);
    if (!result.contains(name)) {
      result[name] = cells;
      continue;
    }
    const py::object before = result[name];
    py::list all;
    if (py::isinstance<py::list>(before))
      all = before;
    else
      all.append(before);
    all.append(cells);
    result[name] = all;
  }
  return result;
}

py::dict node_sets(const py::object& self) {
  py::dict result;
  for (const NodeSet& set : self.cast<const Mesh&>().node_sets)
    result[py::str(set.name)] = view(set.nodes.data(), {static_cast<py::ssize_t>(set.nodes.size())}, self);
  return result;
}

py::dict side_sets(const Mesh& mesh) {
  py::dict result;
  for (const SideSet& set : mesh.side_sets) result[py::str(set.name)] = corners(mesh, set.sides);
  return result;
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<Mesh>(module, "Mesh", R"(A mesh, whole and in memory.

points: array of points x 2 or 3 coordinates [L0]. blocks: cells by name, arrays of cells x node numbers from 0 in the
order of Exodus; the number of nodes tells the type: in the plane 3, 6 and 7 for triangles, 4 and 9 for quadrilaterals;
in space 4, 10 and 15 for tetrahedra, 5, 14 and 19 for pyramids, 6, 18 and 21 for prisms, 8 and 27 for hexahedra. A
block with cells of several types is a list of such arrays. node_sets: arrays of node numbers by name. side_sets: arrays
of sides x 2, 3 or 4 node numbers, those of the corners, by name; a triangle beside quadrilaterals has -1 as the last
one; a side lies on the boundary. ties: by node that follows others, the weights of these by node, whose sum is 1: its
displacement is the sum of weight times theirs. Raises InputError for arrays that do not fit each other and for inverted
cells.)")
      .def(py::init(&make_mesh), py::arg("points"), py::arg("blocks"), py::arg("node_sets") = py::dict(),
           py::arg("side_sets") = py::dict(), py::arg("ties") = py::dict())
      .def_static(
          "read", [](const std::filesystem::path& path) { return read_exodus_mesh(path.string()); }, py::arg("path"),
          "Reads an Exodus file.")
      .def_static(
          "joined",
          [](const py::dict& parts, double merge) {
            std::vector<MeshPart> all;
            for (const auto& [name, mesh] : parts) all.push_back({py::str(name), mesh.cast<const Mesh&>()});
            Mesh joined = joined_parts(all);
            if (!(merge >= 0)) throw InputError(fmt::format("merge: {} is no distance", merge));
            if (merge > 0) merge_parts(all, merge, joined);
            return joined;
          },
          py::arg("parts"), py::arg("merge") = 0.0,
          "Joins meshes, by name, into one. The names of blocks and sets begin with that of their part: "
          "\"left_surface\". merge: distance up to which nodes of different parts become one, as Mesh/Parts/Merge; 0 "
          "leaves them apart. Raises InputError if the meshes do not fit each other.")
      .def_static("of",
                  [](const SceneList& scene) {
                    return at_scene(scene.file, {}, [&] {
                      Teuchos::ParameterList complete = complete_scene(scene.list);
                      return scene_mesh(complete.sublist("Mesh"), scene.folder());
                    });
                  })
      .def(
          "write",
          [](const Mesh& mesh, const std::filesystem::path& path, const std::string& title, bool overwrite) {
            std::error_code code;  // what cannot be looked at cannot be written either
            if (!overwrite && std::filesystem::exists(std::filesystem::symlink_status(path, code)))
              throw InputError(path.string() + " exists; choose another name, or replace it with overwrite=True");
            write_mesh(mesh, path.string(), title);
            const std::string words = lost_ties(mesh);
            if (!words.empty() && PyErr_WarnEx(PyExc_UserWarning, words.c_str(), 1) != 0) throw py::error_already_set();
          },
          py::arg("path"), py::arg("title") = "mesh", py::arg("overwrite") = false,
          "Writes an Exodus file, which a scene names as Mesh/Exodus/File; if the path ends in .msh, one of gmsh, "
          "Mesh/Gmsh/File, which has no title. Warns of ties, which no file holds. Raises InputError if the file "
          "exists, unless it may be overwritten, or if gmsh's format cannot hold the mesh.")
      .def_property_readonly("dimension", [](const Mesh& mesh) { return mesh.dimension; })
      .def_property_readonly(
          "points",
          [](const py::object& self) {
            const auto& mesh = self.cast<const Mesh&>();
            return view(mesh.coordinates.data(), {mesh.nodes(), mesh.dimension}, self);
          },
          "Coordinates, nodes x dimension [L0]: a view.")
      .def_property_readonly("blocks", &blocks, "Node numbers of the cells by block: views.")
      .def_property_readonly("node_sets", &node_sets, "Node numbers by set: views.")
      .def_property_readonly("side_sets", &side_sets, "Corners of the sides by set.")
      .def_property_readonly(
          "ties", &ties,
          "The weights of the nodes that each tied node follows, by node: hanging nodes, and those of "
          "tied surfaces and of periodic sides. None of these nodes is tied.")
      .def_property_readonly(
          "boundary", [](const Mesh& mesh) { return corners(mesh, boundary_sides(mesh)); },
          "Corners of all sides of the boundary.")
      .def_property_readonly(
          "quality", [](const Mesh& mesh) { return to_string(mesh_quality(mesh)); }, "Three lines about the cells.")
      .def("__repr__", [](const Mesh& mesh) {
        return fmt::format("<ixos.Mesh: {} dimensions, {} nodes, {} cells>", mesh.dimension, mesh.nodes(),
                           mesh.cells());
      });
}

}  // namespace ixos::python
