/// How this process was started.
#pragma once
#include <vector>

namespace ixos {

/// Returns whether a launcher of MPI (mpirun, srun) started this process.
bool is_launched();

/// Sets variables of Open MPI and hwloc for the start of a process that no launcher started, and removes them at its
/// end, so that no child inherits them. Without them, Open MPI 4 starts a server for the process and looks for
/// networks, which takes as long as a small scene. It also loads the collective operations of several processes, and
/// hwloc looks for devices; both take a hundredth of a second. Processes without a server would share a folder of
/// temporary files, and remove it from under each other; one process needs none. Variables that the user set stay.
class SingleStart {
 public:
  SingleStart();
  ~SingleStart();
  SingleStart(const SingleStart&) = delete;
  SingleStart& operator=(const SingleStart&) = delete;

 private:
  std::vector<const char*> set_;
};

/// Lets OpenBLAS work on one thread, unless the user set a number of threads (OPENBLAS_NUM_THREADS, OMP_NUM_THREADS).
/// Ranks already use all cores. Matrices of a factorisation are so small that threads wait for each other: a scene
/// takes several times as long if another program needs the cores. Other libraries of BLAS stay as they are.
void use_one_blas_thread();

/// Returns the number of threads of OpenBLAS; 0 if BLAS is another library.
int blas_threads();

}  // namespace ixos
