#include "ixos/answers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "base/simd_width.hpp"
#include "console.hpp"
#include "ixos/launch.hpp"
#include "parameters/parameter_entries.hpp"
#include "solve/direct/factorization.hpp"
#include "solve/direct/klu2_repair.hpp"
#include "time/catalogue.hpp"

namespace ixos {

void print_schemes() {
  for (const Scheme& scheme : schemes()) {
    console::say("{}\n  order:     {}\n  stability: {}\n  conserves: {}\n  cost:      {}\n  from:      {}\n",
                 scheme.name, scheme.order, scheme.stability, scheme.conserves, scheme.cost, scheme.citation);
    for (const auto& [name, entry] : entries(scheme.parameters)) {
      std::ostringstream value;
      value << entry.getAny(false);
      console::say("  {} = {}: {}\n", name, value.str(), entry.docString());
    }
  }
}

void print_version() {
  console::say("ixos {}\nSIMD: {} doubles wide\nFactorisations: {}\n", IXOS_VERSION, simd_width(),
               fmt::format("{}", fmt::join(factorizations(), ", ")));
  if (const std::string klu2 = klu2_library(); !klu2.empty()) console::say("KLU2 from: {}\n", klu2);
  if (const int threads = blas_threads(); threads > 0) console::say("Threads of OpenBLAS: {}\n", threads);
}

}  // namespace ixos
