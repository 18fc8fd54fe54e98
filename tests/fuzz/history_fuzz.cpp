// A history that a restart would go on with: a byte each of rows and bytes that it should have, then the file.
#include "base/error.hpp"
#include "input.hpp"
#include "io/history_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  if (size < 2) return 0;
  const TableLength length{data[0], data[1]};
  const fuzz::MemoryFile file(data + 2, size - 2);
  try {
    HistoryFile::verify(file.path(), {"time", "gap"}, "time", length);
  } catch (const InputError& error) {
    fuzz::expect_message(error);
    return 0;
  }
  fuzz::expect(length.bytes <= size - 2, "a table is longer than its file");
  HistoryFile(file.path(), length).write({1, 2});
  return 0;
}
