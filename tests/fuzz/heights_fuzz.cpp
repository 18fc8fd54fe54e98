// Files of heights.
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "input.hpp"
#include "io/height_grid.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  const fuzz::MemoryFile file(data, size);
  try {
    const HeightGrid grid = read_height_grid(file.path());
    fuzz::expect(grid.rows > 0 && grid.columns > 0 && grid.heights.size() == grid.rows * grid.columns,
                 "a field has other heights than its rows and columns say");
    fuzz::expect(grid.row_spacing >= 0 && grid.column_spacing >= 0, "a spacing is negative");
    fuzz::expect(std::all_of(grid.heights.begin(), grid.heights.end(), [](double h) { return std::isfinite(h); }),
                 "a height is not finite");
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}
