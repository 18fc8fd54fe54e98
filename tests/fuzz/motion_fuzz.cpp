// Motions by expressions: value, rate and acceleration on a line each, checked against each other.
#include "base/error.hpp"
#include "histories/time_function.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  const std::vector<std::string> lines = fuzz::pieces(fuzz::text(data, size), "\n", 3);
  try {
    check_over(*expression(lines[0], lines[1], lines[2]), 0, 1, true);
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}
