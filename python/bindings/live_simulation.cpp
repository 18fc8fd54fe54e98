#include "live_simulation.hpp"

#include <filesystem>

#include "scene_list.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

/// Where the object's own dictionary has the list: Python's collector sees it there.
constexpr const char* observers_key = "_observers";

}  // namespace

LiveSimulation::LiveSimulation(const Teuchos::ParameterList& scene, const std::string& file, const py::object& comm,
                               const Mesh* mesh)
    : file_(file), comm_(comm), end_([this] { simulation_.reset(); }) {
  const Comm ranks = communicator(comm_);
  const std::string folder = std::filesystem::path(file).parent_path().string();
  const py::gil_scoped_release free;
  simulation_ = at_scene(file, {}, [&] {
    return mesh != nullptr ? std::make_unique<Simulation>(scene, *mesh, ranks)
                           : std::make_unique<Simulation>(scene, ranks, folder);
  });
}

Simulation& LiveSimulation::get() const {
  if (!simulation_) throw std::runtime_error("the simulation has ended with Ixos' session");
  return *simulation_;
}

py::list observers(const py::object& simulation) {
  return simulation.attr("__dict__").attr("setdefault")(observers_key, py::list());
}

void notify(const py::object& simulation) {
  const auto own = py::reinterpret_steal<py::dict>(PyObject_GenericGetDict(simulation.ptr(), nullptr));
  if (!own.contains(observers_key)) return;  // most simulations have none, and steps may be short
  // A copy: an observer may remove itself.
  for (const py::handle observer : py::tuple(own[observers_key])) observer(simulation);
}

}  // namespace ixos::python
