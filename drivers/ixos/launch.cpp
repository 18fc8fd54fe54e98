#include "ixos/launch.hpp"

#include <cstdlib>
#include <utility>

namespace ixos {

std::string launched_rank() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
    if (const char* rank = std::getenv(name); rank != nullptr) return rank;
  return "";
}

SingleStart::SingleStart() {
  if (!launched_rank().empty()) return;
  for (const auto& [name, value] : {std::pair{"OMPI_MCA_ess_singleton_isolated", "1"},
                                    {"OMPI_MCA_orte_create_session_dirs", "0"},
                                    {"OMPI_MCA_pml", "ob1"},
                                    {"OMPI_MCA_btl", "self"}})
    if (std::getenv(name) == nullptr && setenv(name, value, 0) == 0) set_.push_back(name);
}

SingleStart::~SingleStart() {
  for (const char* name : set_) unsetenv(name);
}

}  // namespace ixos
