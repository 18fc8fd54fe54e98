// The rank's part of the mesh.
#include <algorithm>
#include <set>

#include "arrays.hpp"
#include "bindings.hpp"
#include "live_simulation.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

const LocalMesh& mesh_of(const py::object& self) { return self.cast<const LiveSimulation&>().model().mesh(); }

/// A block of the rank's part: its number, and the simulation that has it.
struct Block {
  std::size_t number;
  py::object simulation;
  const LocalBlock& get() const { return mesh_of(simulation).blocks[number]; }
};

py::list blocks(const py::object& self) {
  py::list result;
  for (std::size_t number = 0; number < mesh_of(self).blocks.size(); ++number) result.append(Block{number, self});
  return result;
}

/// A side set has the nodes of its sides, but for those that stand for derivatives.
py::array nodes_of_set(const py::object& self, const std::string& name) {
  const LocalMesh& mesh = mesh_of(self);
  const auto has = [&name](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (!has(mesh.node_set_names) && has(mesh.side_set_names)) {
    std::set<int> nodes;
    for (const LocalSide& side : mesh.side_sets[mesh.side_set(name)])
      for (const int node : side.nodes)
        if (!mesh.is_derivative(static_cast<std::size_t>(node))) nodes.insert(node);
    return taken(std::vector<int>(nodes.begin(), nodes.end()), {static_cast<py::ssize_t>(nodes.size())});
  }
  const std::vector<int>& nodes = mesh.node_sets[mesh.node_set(name)];
  return view(nodes.data(), {static_cast<py::ssize_t>(nodes.size())}, self);
}

}  // namespace

void bind_local_mesh(py::module_& module, SimulationClass& simulation) {
  py::class_<Block>(module, "Block", "The cells of a block that a rank has, owned ones and ghosts.")
      .def_property_readonly("name", [](const Block& b) { return b.get().name; })
      .def_property_readonly(
          "nodes",
          [](const Block& b) {
            const LocalBlock& block = b.get();
            return view(block.nodes.data(), {block.cells(), nodes_per_cell(block.type)}, b.simulation);
          },
          "Local node numbers, cells x nodes per cell: a view. Enriched cells have their further nodes last.")
      .def_property_readonly(
          "owned",
          [](const Block& b) {
            const LocalBlock& block = b.get();
            return view(reinterpret_cast<const bool*>(block.owned.data()), {block.cells()}, b.simulation);
          },
          "Whether the rank owns the cell: a view.");
  simulation.def_property_readonly("dimension", [](const LiveSimulation& s) { return s.model().mesh().dimension; })
      .def_property_readonly(
          "degrees_of_freedom", [](const LiveSimulation& s) { return s.model().space().global(); }, "On all ranks.")
      .def_property_readonly(
          "owned_nodes", [](const LiveSimulation& s) { return s.model().mesh().owned_nodes; },
          "The number of nodes that the rank owns. They come first in all arrays.")
      .def_property_readonly(
          "points",
          [](const py::object& self) {
            const LocalMesh& mesh = mesh_of(self);
            return view(mesh.coordinates.data(), {mesh.nodes(), mesh.dimension}, self);
          },
          "Reference coordinates, nodes x dimension [L0]: a view.")
      .def_property_readonly(
          "mesh_nodes",
          [](const py::object& self) { return view(mesh_of(self).original_ids.data(), {mesh_of(self).nodes()}, self); },
          "By local node, its number in the whole mesh: a view. Gather arrays of several ranks with it.")
      .def_property_readonly("blocks", &blocks)
      .def("node_set", &nodes_of_set, py::arg("name"),
           "Returns the local node numbers of a node set: a view; or of the nodes of a side set, if no node set has "
           "that name: ascending numbers.");
}

}  // namespace ixos::python
