// Compiled with -O2 -fno-ivopts: see klu2_repair.hpp.
#include "solve/direct/klu2_repair.hpp"

#include <Trilinos_version.h>

#if TRILINOS_MAJOR_VERSION < 14

#include <dlfcn.h>

#include <Amesos2_KLU2_decl.hpp>
#include <Amesos2_KLU2_def.hpp>
#include <Amesos2_SolverCore_def.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>
#include <typeinfo>

#include "base/tpetra.hpp"

namespace Amesos2 {
template class SolverCore<KLU2, ixos::CrsMatrix, ixos::MultiVector>;
template class KLU2<ixos::CrsMatrix, ixos::MultiVector>;
}  // namespace Amesos2

namespace ixos {
namespace {

using Repaired = Amesos2::KLU2<CrsMatrix, MultiVector>;

}  // namespace

void anchor_klu2_repair() {}

std::string klu2_library() {
  const std::string vtable = std::string("_ZTV") + (typeid(Repaired).name());
  Dl_info info{};
  void* symbol = dlsym(RTLD_DEFAULT, vtable.c_str());
  if (symbol == nullptr || dladdr(symbol, &info) == 0) return "unknown";
  const std::string path = info.dli_fname;
  return path.substr(path.find_last_of('/') + 1);
}

}  // namespace ixos

#else

namespace ixos {

void anchor_klu2_repair() {}

std::string klu2_library() { return {}; }

}  // namespace ixos

#endif
