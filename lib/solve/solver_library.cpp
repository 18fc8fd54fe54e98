#include "solve/solver_library.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#include "base/error.hpp"

namespace ixos {
namespace {

std::filesystem::path library_path() {
  const std::string name = "libixos_solvers.so." IXOS_SOVERSION;
  Dl_info here{};
  if (dladdr(reinterpret_cast<const void*>(&solver_library), &here) == 0) return name;
  const std::filesystem::path folder = std::filesystem::path(here.dli_fname).parent_path();
  std::error_code none;
  for (const std::filesystem::path& place : {folder / name, folder / "../.." / name})
    if (std::filesystem::exists(place, none)) return place;
  return name;  // where the loader finds it
}

const SolverLibrary& load() {
  const std::filesystem::path path = library_path();
  using Get = const SolverLibrary* (*)();
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  const auto get = library != nullptr ? reinterpret_cast<Get>(dlsym(library, "ixos_solver_library")) : nullptr;
  if (get == nullptr) throw FileError(std::string("cannot load the library of linear solvers: ") + dlerror());
  return *get();
}

}  // namespace

const SolverLibrary& solver_library() {
  static const SolverLibrary& library = load();
  return library;
}

}  // namespace ixos
