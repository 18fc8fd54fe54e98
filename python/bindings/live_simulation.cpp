#include "live_simulation.hpp"

#include <filesystem>
#include <thread>
#include <utility>

#include "scene_list.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

/// Where the object's own dictionary has the list: Python's collector sees it there.
constexpr const char* observers_key = "_observers";

// The guards Computing that exist, and the thread that has them. Read and written with the interpreter held only.
int computing = 0;
std::thread::id computing_thread;

}  // namespace

LiveSimulation::LiveSimulation(const Teuchos::ParameterList& scene, const std::string& file, const py::object& comm,
                               const Mesh* mesh)
    : file_(file), comm_(comm), end_([this] {
        simulation_.reset();
        earlier_.clear();
      }) {
  const Comm ranks = communicator(comm_);
  const std::string folder = std::filesystem::path(file).parent_path().string();
  const Computing guard;
  simulation_ = at_scene(file, {}, [&] {
    return mesh != nullptr ? std::make_unique<Simulation>(scene, *mesh, ranks)
                           : std::make_unique<Simulation>(scene, ranks, folder);
  });
}

void LiveSimulation::go_on_with(std::shared_ptr<Simulation> stage) {
  earlier_.push_back(std::move(simulation_));
  simulation_ = std::move(stage);
}

Simulation& LiveSimulation::get() const {
  if (!simulation_) throw std::runtime_error("the simulation has ended with Ixos' session");
  Computing::check();
  return *simulation_;
}

Computing::Computing() {
  check();
  computing_thread = std::this_thread::get_id();
  ++computing;
  release_.emplace();
}

Computing::~Computing() {
  release_.reset();
  --computing;
}

void Computing::check() {
  if (computing > 0 && computing_thread != std::this_thread::get_id())
    throw std::runtime_error("another thread computes with Ixos; wait until it is done");
}

Changing::Changing(LiveSimulation& simulation) : simulation_(simulation) {
  simulation_.get();
  if (simulation_.changing_)
    throw std::runtime_error("the simulation is within a step or a run: an observer may read it, but not change it");
  simulation_.changing_ = true;
}

py::list observers(const py::object& simulation) {
  return simulation.attr("__dict__").attr("setdefault")(observers_key, py::list());
}

bool has_observers(const py::object& simulation) {
  const auto own = py::reinterpret_steal<py::dict>(PyObject_GenericGetDict(simulation.ptr(), nullptr));
  return own.contains(observers_key) && py::len(own[observers_key]) > 0;
}

void notify(const py::object& simulation) {
  if (!has_observers(simulation)) return;  // most simulations have none, and steps may be short
  // A copy: an observer may remove itself.
  for (const py::handle observer : py::tuple(observers(simulation))) observer(simulation);
}

}  // namespace ixos::python
