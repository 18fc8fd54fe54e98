#include "io/classic_layout.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "io/netcdf_classic.hpp"

namespace ixos {
namespace {

constexpr std::size_t largest_header = 1 << 24;                  ///< far more than the names of fields take
constexpr std::uint64_t most_numbers = std::uint64_t{1} << 40U;  ///< of a variable
constexpr std::uint64_t largest_file = std::uint64_t{1} << 62U;  ///< bytes

template <std::size_t Bytes>
std::array<char, Bytes> high_byte_first(std::uint64_t value) {
  std::array<char, Bytes> bytes{};
  for (std::size_t i = 0; i < Bytes; ++i) bytes[Bytes - 1 - i] = static_cast<char>((value >> (8 * i)) & 0xffU);
  return bytes;
}

/// Returns the doubles in a row of a variable that grows along its first dimension.
std::uint64_t numbers_in_row(const NetcdfClassic& file, const NetcdfClassic::Variable& variable) {
  std::uint64_t numbers = 1;
  for (std::size_t k = 1; k < variable.dimensions.size(); ++k) {
    const std::uint64_t length = file.dimensions()[variable.dimensions[k]].length;
    if (length == 0 || length > most_numbers / numbers) file.refuse_header();
    numbers *= length;
  }
  return numbers;
}

}  // namespace

ClassicLayout read_classic_layout(const DiskFile& file, const std::string& path) {
  std::string bytes(std::min<std::uint64_t>(file.length(), largest_header), '\0');
  bytes.resize(file.read_at(0, bytes.data(), bytes.size()));
  const NetcdfClassic header(path, bytes);
  if (bytes[3] != '\x02') header.refuse_header();
  ClassicLayout layout;
  for (const NetcdfClassic::Variable& variable : header.variables()) {
    if (variable.dimensions.empty() || header.dimensions()[variable.dimensions.front()].length != 0) continue;
    if (variable.type != NetcdfClassic::double_type || variable.begin > largest_file) header.refuse_header();
    if (layout.variables.empty()) layout.first_record = variable.begin;
    if (variable.begin < layout.first_record) header.refuse_header();
    const std::uint64_t numbers = numbers_in_row(header, variable);
    layout.variables.push_back({variable.name, variable.begin - layout.first_record, numbers});
    layout.record_bytes += 8 * numbers;
  }
  if (layout.variables.empty() || layout.first_record < header.header_bytes()) header.refuse_header();
  for (const ClassicLayout::Variable& variable : layout.variables)
    if (variable.offset + 8 * variable.numbers > layout.record_bytes) header.refuse_header();
  return layout;
}

void write_record_count(DiskFile& file, int records) {
  const auto bytes = high_byte_first<4>(static_cast<std::uint64_t>(records));
  file.write_at(4, bytes.data(), bytes.size());
}

void append_numbers(const std::vector<double>& values, std::vector<char>& record) {
  for (const double value : values) {
    std::uint64_t word = 0;
    std::memcpy(&word, &value, sizeof(word));
    const auto bytes = high_byte_first<8>(word);
    record.insert(record.end(), bytes.begin(), bytes.end());
  }
}

}  // namespace ixos
