/// The beginning and the end of MPI and Kokkos in a Python process.
#pragma once
#include <pybind11/pybind11.h>

#include <functional>

#include "base/tpetra.hpp"

namespace ixos::python {

/// Starts HDF5, MPI unless it runs (mpi4py may have started it), and Kokkos. At the interpreter's end it first destroys
/// what is registered, because Kokkos' memory must be gone before Kokkos ends, and then ends Kokkos, and MPI if it
/// started it. Python calls functions of atexit last in, first out, and mpi4py ends MPI after all of them.
void start_session();

/// Registers what must be destroyed before the session ends, as long as this object exists.
class EndsWithSession {
 public:
  explicit EndsWithSession(std::function<void()> destroy);
  ~EndsWithSession();
  EndsWithSession(const EndsWithSession&) = delete;
  EndsWithSession& operator=(const EndsWithSession&) = delete;

 private:
  std::function<void()> destroy_;
  long number_ = 0;
  friend void end_session();
};

/// Returns the communicator of an object of mpi4py; that of all ranks for None. The object must outlive it.
Comm communicator(const pybind11::object& object);

}  // namespace ixos::python
