#include "session.hpp"

#include <mpi.h>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>
#include <map>
#include <stdexcept>
#include <utility>

#include "io/hdf5_file.hpp"
#include "solve/direct/klu2_repair.hpp"

namespace py = pybind11;

namespace ixos::python {
namespace {

/// The living objects in the order of their making. It is that of all ranks: destroying a solver may be collective.
std::map<long, EndsWithSession*>& living() {
  static auto* objects = new std::map<long, EndsWithSession*>;  // never destroyed: Python's objects may outlive statics
  return *objects;
}

bool ended = false;

}  // namespace

void end_session() {
  ended = true;
  for (const auto& [number, object] : std::exchange(living(), {})) object->destroy_();
  Tpetra::finalize();
}

void start_session() {
  anchor_klu2_repair();
  start_hdf5();
  static int argc = 1;  // Kokkos keeps the addresses and cannot do with null ones
  static char name[] = "python3";
  static char* arguments[] = {name, nullptr};
  static char** argv = arguments;
  Tpetra::initialize(&argc, &argv);
  py::module_::import("atexit").attr("register")(py::cpp_function([] { end_session(); }));
}

EndsWithSession::EndsWithSession(std::function<void()> destroy) : destroy_(std::move(destroy)) {
  if (ended) throw std::runtime_error("Python is about to end: no simulation can be made");
  static long made = 0;
  number_ = ++made;
  living()[number_] = this;
}

EndsWithSession::~EndsWithSession() { living().erase(number_); }

Comm communicator(const py::object& object) {
  if (object.is_none()) return Tpetra::getDefaultComm();
  if (!py::hasattr(object, "py2f"))
    throw py::type_error("comm: " + py::repr(object).cast<std::string>() + " is not a communicator of mpi4py");
  const auto handle = object.attr("py2f")().cast<MPI_Fint>();  // the same MPI: no header of mpi4py is needed
  return Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_Comm_f2c(handle)));
}

}  // namespace ixos::python
