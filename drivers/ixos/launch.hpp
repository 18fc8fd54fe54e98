/// How this process was started.
#pragma once
#include <string>
#include <vector>

namespace ixos {

/// Returns this process's rank if a launcher of MPI (mpirun, srun) started it, else an empty text.
std::string launched_rank();

/// Sets variables of Open MPI for the start of a process that no launcher started, and removes them at its end, so that
/// no child inherits them. Without them, Open MPI starts a server for the process and looks for networks, which takes
/// as long as a small scene. Processes without a server would share a folder of temporary files, and remove it from
/// under each other; one process needs none. Variables that the user set stay. Another MPI ignores them all.
class SingleStart {
 public:
  SingleStart();
  ~SingleStart();
  SingleStart(const SingleStart&) = delete;
  SingleStart& operator=(const SingleStart&) = delete;

 private:
  std::vector<const char*> set_;
};

}  // namespace ixos
