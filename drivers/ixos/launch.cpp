#include "ixos/launch.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <utility>

namespace ixos {

bool is_launched() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

SingleStart::SingleStart() {
  if (is_launched()) return;
  for (const auto& [name, value] : {std::pair{"OMPI_MCA_ess_singleton_isolated", "1"},
                                    {"OMPI_MCA_orte_create_session_dirs", "0"},
                                    {"OMPI_MCA_pml", "ob1"},
                                    {"OMPI_MCA_btl", "self"},
                                    {"OMPI_MCA_coll", "self,basic,libnbc"},
                                    {"HWLOC_COMPONENTS", "-pci,-linuxio"}})
    if (std::getenv(name) == nullptr && setenv(name, value, 0) == 0) set_.push_back(name);
}

SingleStart::~SingleStart() {
  for (const char* name : set_) unsetenv(name);
}

void use_one_blas_thread() {
  for (const char* name : {"OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "OMP_NUM_THREADS"})
    if (std::getenv(name) != nullptr) return;
  if (void* const set = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"); set != nullptr)
    reinterpret_cast<void (*)(int)>(set)(1);
}

int blas_threads() {
  void* const get = dlsym(RTLD_DEFAULT, "openblas_get_num_threads");
  return get != nullptr ? reinterpret_cast<int (*)()>(get)() : 0;
}

}  // namespace ixos
