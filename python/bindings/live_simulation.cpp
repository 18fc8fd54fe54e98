#include "live_simulation.hpp"

#include <filesystem>

#include "scene_list.hpp"

namespace py = pybind11;

namespace ixos::python {

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

void notify(const py::object& simulation) {
  // A copy: an observer may remove itself.
  for (const py::handle observer : py::list(simulation.attr("observers"))) observer(simulation);
}

}  // namespace ixos::python
