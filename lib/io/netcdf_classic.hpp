/// Variables in files of netCDF's classic formats.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ixos {

/// A file in the formats CDF-1, CDF-2 or CDF-5 ("NetCDF Classic Format Specification", Unidata), in memory. Trusts
/// nothing: what is not as the format demands ends in an InputError that begins with the path. A dimension that grows
/// has the length 0 here, as if no record were there.
class NetcdfClassic {
 public:
  /// `bytes` must outlive the object; its values may be left out where nobody asks for them.
  NetcdfClassic(std::string path, const std::string& bytes);

  struct Attribute {
    std::string name, text;       ///< the text of an attribute of characters
    std::vector<double> numbers;  ///< of an attribute of numbers
  };
  struct Variable {
    std::string name;
    std::vector<std::size_t> dimensions;  ///< indices into dimensions()
    std::vector<Attribute> attributes;
    int type = 0;             ///< as the format numbers it
    std::uint64_t begin = 0;  ///< position of its values, in a variable that grows of those of record 0

    /// Returns the attribute of that name, or null.
    const Attribute* attribute(const std::string& name) const;
  };
  struct Dimension {
    std::string name;
    std::uint64_t length = 0;
  };

  static constexpr int double_type = 6;  ///< of Variable::type

  const std::vector<Variable>& variables() const { return variables_; }
  const std::vector<Dimension>& dimensions() const { return dimensions_; }

  /// Returns the values of a variable of numbers. Throws InputError if the file is too short to hold them.
  std::vector<double> values(const Variable& variable) const;

  /// Returns the length of the header.
  std::uint64_t header_bytes() const { return place_; }
  /// Throws the InputError of a header that is not as the format, or the caller, demands.
  [[noreturn]] void refuse_header() const;

 private:
  std::string take(std::uint64_t count);
  std::uint64_t number(std::size_t bytes);
  std::uint64_t size() { return number(wide_ ? 8 : 4); }
  std::uint64_t count_of(std::uint64_t tag, std::uint64_t least_bytes);
  std::vector<Attribute> read_attributes();
  Variable read_variable();

  std::string path_;
  const std::string& bytes_;
  std::uint64_t place_ = 0;
  bool wide_ = false;            ///< CDF-5: sizes have 8 bytes
  std::size_t begin_bytes_ = 4;  ///< of a position
  std::vector<Dimension> dimensions_;
  std::vector<Variable> variables_;
};

}  // namespace ixos
