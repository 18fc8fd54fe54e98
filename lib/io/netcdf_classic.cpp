#include "io/netcdf_classic.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "base/error.hpp"

namespace ixos {
namespace {

constexpr int characters = 2, single_precision = 5;
/// Bytes by type: byte, char, short, int, float, double; of CDF-5 unsigned byte, short, int, and int64, unsigned int64.
constexpr std::array<std::uint64_t, 12> bytes_of{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
constexpr std::uint64_t dimension_tag = 10, variable_tag = 11, attribute_tag = 12;

bool is_type(std::uint64_t type, bool wide) { return type >= 1 && type <= (wide ? 11U : 6U); }

/// Returns a number of that type, high byte first.
double decoded(const char* data, int type) {
  const std::uint64_t bytes = std::max<std::uint64_t>(1, bytes_of[static_cast<std::size_t>(type)]);
  std::uint64_t word = 0;
  for (std::uint64_t i = 0; i < bytes; ++i) word = word << 8U | static_cast<unsigned char>(data[i]);
  if (type == NetcdfClassic::double_type) {
    double value = 0;
    std::memcpy(&value, &word, sizeof value);
    return value;
  }
  if (type == single_precision) {
    const auto half = static_cast<std::uint32_t>(word);
    float value = 0;
    std::memcpy(&value, &half, sizeof value);
    return value;
  }
  const bool is_signed = type <= 4 || type == 10;
  if (!is_signed || word >> (8 * bytes - 1) == 0) return static_cast<double>(word);
  const std::uint64_t mask = bytes == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * bytes)) - 1;
  return -static_cast<double>((~word & mask) + 1);
}

}  // namespace

const NetcdfClassic::Attribute* NetcdfClassic::Variable::attribute(const std::string& wanted) const {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const Attribute& a) { return a.name == wanted; });
  return found == attributes.end() ? nullptr : &*found;
}

NetcdfClassic::NetcdfClassic(std::string path, const std::string& bytes) : path_(std::move(path)), bytes_(bytes) {
  const std::string start = take(4);
  const char version = start[3];
  if (start.compare(0, 3, "CDF") != 0 || (version != 1 && version != 2 && version != 5)) refuse_header();
  wide_ = version == 5;
  begin_bytes_ = version == 1 ? 4 : 8;
  size();  // of records
  for (std::uint64_t count = count_of(dimension_tag, wide_ ? 16 : 8); count > 0; --count) {
    Dimension dimension;
    dimension.name = take(size());
    dimension.length = size();
    dimensions_.push_back(std::move(dimension));
  }
  read_attributes();  // of the file
  for (std::uint64_t count = count_of(variable_tag, 20); count > 0; --count) variables_.push_back(read_variable());
}

void NetcdfClassic::refuse_header() const { throw InputError(path_ + ": its header is damaged"); }

std::string NetcdfClassic::take(std::uint64_t count) {
  const std::uint64_t padded = (count + 3) / 4 * 4;
  if (padded < count || padded > bytes_.size() - place_) refuse_header();
  std::string text = bytes_.substr(place_, count);
  place_ += padded;
  return text;
}

std::uint64_t NetcdfClassic::number(std::size_t bytes) {
  std::uint64_t value = 0;
  for (const char byte : take(bytes)) value = value << 8U | static_cast<unsigned char>(byte);
  return value;
}

/// Returns the number of entries of a list, whose tag is that or absent. The rest of the file must be able to hold
/// them.
std::uint64_t NetcdfClassic::count_of(std::uint64_t tag, std::uint64_t least_bytes) {
  const std::uint64_t found = number(4), count = size();
  if (found != tag && (found != 0 || count != 0)) refuse_header();
  if (count > (bytes_.size() - place_) / least_bytes) refuse_header();
  return count;
}

std::vector<NetcdfClassic::Attribute> NetcdfClassic::read_attributes() {
  std::vector<Attribute> result;
  for (std::uint64_t count = count_of(attribute_tag, 12); count > 0; --count) {
    Attribute attribute;
    attribute.name = take(size());
    const std::uint64_t type = number(4), values = size();
    if (!is_type(type, wide_) || values > bytes_.size()) refuse_header();
    const std::uint64_t bytes = bytes_of[type];
    const std::string data = take(values * bytes);
    if (type == characters)
      attribute.text = data.substr(0, std::min(data.find('\0'), data.size()));
    else
      for (std::uint64_t k = 0; k < values; ++k)
        attribute.numbers.push_back(decoded(data.data() + k * bytes, static_cast<int>(type)));
    result.push_back(std::move(attribute));
  }
  return result;
}

NetcdfClassic::Variable NetcdfClassic::read_variable() {
  Variable variable;
  variable.name = take(size());
  const std::uint64_t rank = size();
  if (rank > dimensions_.size()) refuse_header();
  for (std::uint64_t k = 0; k < rank; ++k) {
    const std::uint64_t dimension = size();
    if (dimension >= dimensions_.size()) refuse_header();
    variable.dimensions.push_back(dimension);
  }
  variable.attributes = read_attributes();
  const std::uint64_t type = number(4);
  if (!is_type(type, wide_)) refuse_header();
  variable.type = static_cast<int>(type);
  size();  // its bytes, once more
  variable.begin = number(begin_bytes_);
  return variable;
}

std::vector<double> NetcdfClassic::values(const Variable& variable) const {
  const std::uint64_t bytes = bytes_of[static_cast<std::size_t>(variable.type)];
  const std::uint64_t room = variable.begin > bytes_.size() ? 0 : (bytes_.size() - variable.begin) / bytes;
  std::uint64_t count = 1;
  for (const std::size_t dimension : variable.dimensions) {
    const std::uint64_t length = dimensions_[dimension].length;
    if (length != 0 && count > room / length) throw InputError(path_ + ": ends before the values of " + variable.name);
    count *= length;
  }
  if (variable.type == characters) throw InputError(path_ + ": the values of " + variable.name + " are no numbers");
  std::vector<double> result(count);
  for (std::uint64_t k = 0; k < count; ++k)
    result[k] = decoded(bytes_.data() + variable.begin + k * bytes, variable.type);
  return result;
}

}  // namespace ixos
