#include "io/classic_layout.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "base/error.hpp"

namespace ixos {
namespace {

constexpr std::size_t largest_header = 1 << 24;  ///< far more than the names of fields take
constexpr std::uint32_t double_type = 6;
constexpr std::uint64_t most_numbers = std::uint64_t{1} << 40U;  ///< of a variable
constexpr std::uint64_t largest_file = std::uint64_t{1} << 62U;  ///< bytes

template <std::size_t Bytes>
std::array<char, Bytes> high_byte_first(std::uint64_t value) {
  std::array<char, Bytes> bytes{};
  for (std::size_t i = 0; i < Bytes; ++i) bytes[Bytes - 1 - i] = static_cast<char>((value >> (8 * i)) & 0xffU);
  return bytes;
}

/// The header's grammar, read from memory.
class Header {
 public:
  Header(const DiskFile& file, const std::string& path) : path_(path) {
    bytes_.resize(std::min<std::uint64_t>(file.length(), largest_header));
    bytes_.resize(file.read_at(0, bytes_.data(), bytes_.size()));
  }

  ClassicLayout read() {
    if (take(4) != std::string("CDF\x02")) damaged();
    number<4>();  // of records
    const int record_dimension = read_dimensions();
    skip_attributes();
    ClassicLayout layout;
    for (std::uint64_t count = list(11); count > 0; --count) read_variable(record_dimension, layout);
    if (layout.variables.empty() || layout.first_record < position_) damaged();
    for (ClassicLayout::Variable& variable : layout.variables) {
      variable.offset -= layout.first_record;
      if (variable.offset + 8 * variable.numbers > layout.record_bytes) damaged();
    }
    return layout;
  }

 private:
  [[noreturn]] void damaged() const { throw InputError(path_ + ": its header is damaged"); }

  std::string take(std::uint64_t count) {
    const std::uint64_t padded = (count + 3) / 4 * 4;
    if (padded < count || padded > bytes_.size() - position_) damaged();
    std::string text(bytes_.data() + position_, count);
    position_ += padded;
    return text;
  }
  template <std::size_t Bytes>
  std::uint64_t number() {
    const std::string bytes = take(Bytes);
    std::uint64_t value = 0;
    for (const char byte : bytes) value = value << 8U | static_cast<unsigned char>(byte);
    return value;
  }
  std::string name() { return take(number<4>()); }

  /// The number of elements of a list, whose tag is that or absent.
  std::uint64_t list(std::uint64_t tag) {
    const std::uint64_t found = number<4>(), count = number<4>();
    if (found != tag && (found != 0 || count != 0)) damaged();
    return count;
  }
  /// Returns the number of the dimension that grows.
  int read_dimensions() {
    int growing = -1;
    const std::uint64_t count = list(10);
    for (std::uint64_t i = 0; i < count; ++i) {
      name();
      lengths_.push_back(number<4>());
      if (lengths_.back() == 0) growing = static_cast<int>(i);
    }
    return growing;
  }
  void skip_attributes() {
    static constexpr std::array<std::uint64_t, 7> size{0, 1, 1, 2, 4, 4, 8};
    for (std::uint64_t count = list(12); count > 0; --count) {
      name();
      const std::uint64_t type = number<4>(), values = number<4>();
      if (type < 1 || type >= size.size()) damaged();
      take(values * size[type]);
    }
  }
  void read_variable(int record_dimension, ClassicLayout& layout) {
    ClassicLayout::Variable variable{name(), 0, 1};
    bool grows = false;
    const std::uint64_t rank = number<4>();
    for (std::uint64_t i = 0; i < rank; ++i) {
      const std::uint64_t dimension = number<4>();
      if (dimension >= lengths_.size()) damaged();
      if (static_cast<int>(dimension) == record_dimension) {
        grows = grows || i == 0;
        continue;
      }
      if (lengths_[dimension] > most_numbers / std::max<std::uint64_t>(variable.numbers, 1)) damaged();
      variable.numbers *= lengths_[dimension];
    }
    skip_attributes();
    const std::uint64_t type = number<4>();
    number<4>();  // its size again
    variable.offset = number<8>();
    if (!grows) return;
    if (type != double_type || variable.offset > largest_file) damaged();
    if (layout.variables.empty()) layout.first_record = variable.offset;
    if (variable.offset < layout.first_record) damaged();
    layout.record_bytes += 8 * variable.numbers;
    layout.variables.push_back(std::move(variable));
  }

  std::string path_;
  std::vector<char> bytes_;
  std::size_t position_ = 0;
  std::vector<std::uint64_t> lengths_;  ///< of the dimensions
};

}  // namespace

ClassicLayout read_classic_layout(const DiskFile& file, const std::string& path) { return Header(file, path).read(); }

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
