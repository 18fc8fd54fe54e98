// Tables over time: the input is numbers, the first half of them times.
#include <cmath>
#include <cstring>

#include "base/error.hpp"
#include "histories/time_function.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  std::vector<double> numbers(size / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), data, numbers.size() * sizeof(double));
  const auto half = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  const std::vector<double> times(numbers.begin(), half), values(half, numbers.end());
  try {
    for (const auto other : {TableInterpolation::Unlimited, TableInterpolation::Linear, TableInterpolation::Step}) {
      const auto function = interpolated(times, values, other);
      for (double time : times) function->at(time);
      function->jumps();
    }
    const auto function = interpolated(times, values);
    for (double time : times) function->at(time);
    const double first = function->first_time(), span = function->last_time() - first;
    if (!std::isfinite(span)) return 0;
    fuzz::expect(std::isnan(function->at(first - span).value), "a table speaks of times that it does not have");
    const double start = function->at(first).value;
    fuzz::expect(start == values.front() || std::isnan(start), "a table does not begin with its first value");
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}
