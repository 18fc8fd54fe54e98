/// Where records stand in a file of netCDF's classic format. Included by lib/io only.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/disk_file.hpp"

namespace ixos {

/// The record section of a file in the 64-bit offset variant (CDF-2; "NetCDF Classic Format Specification", Unidata).
/// Each record holds one row of every variable that grows, one after the other, numbers with the high byte first.
struct ClassicLayout {
  struct Variable {
    std::string name;
    std::uint64_t offset;   ///< in a record [bytes]
    std::uint64_t numbers;  ///< doubles in a row
  };
  std::uint64_t first_record = 0;  ///< position of record 0
  std::uint64_t record_bytes = 0;
  std::vector<Variable> variables;  ///< that grow

  std::uint64_t end(int records) const { return first_record + static_cast<std::uint64_t>(records) * record_bytes; }
};

/// Reads the header. Throws InputError, with the path, if it is damaged or a variable that grows does not hold doubles.
ClassicLayout read_classic_layout(const DiskFile& file, const std::string& path);

/// Writes the number of records into the header: readers see this many. Throws FileError.
void write_record_count(DiskFile& file, int records);

/// Appends numbers to a record, high byte first.
void append_numbers(const std::vector<double>& values, std::vector<char>& record);

}  // namespace ixos
