// Expressions in t.
#include "base/error.hpp"
#include "histories/time_function.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  try {
    const auto function = expression(fuzz::text(data, size), "", "");
    for (double time : {0.0, 1.0, -1e300, 1e-300}) function->at(time);
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}
