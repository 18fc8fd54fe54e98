#include "checkpoint/seal.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <vector>

#include "base/error.hpp"
#include "checkpoint/digest.hpp"
#include "io/disk_file.hpp"

namespace ixos {
namespace {

constexpr std::array<char, 16> magic{'I', 'x', 'o', 's', ' ', 'c', 'h', 'e', 'c', 'k', 'p', 'o', 'i', 'n', 't', '\n'};
constexpr std::uint64_t format = 2;

/// The first bytes of the user block; the rest of it is zero.
struct Seal {
  std::array<char, 16> magic;
  std::uint64_t format;
  std::uint64_t length;                   ///< of the file
  std::array<std::uint64_t, 2> checksum;  ///< of the file, these numbers taken as 0
};

/// The checksum of a file whose seal is this one.
std::array<std::uint64_t, 2> checksum(DiskFile& file, Seal seal) {
  Digest digest;
  seal.checksum = {};
  digest.add(&seal, sizeof(seal));
  std::vector<char> buffer(1 << 20);
  file.seek(sizeof(seal));
  for (std::size_t count = file.read(buffer.data(), buffer.size()); count > 0;
       count = file.read(buffer.data(), buffer.size()))
    digest.add(buffer.data(), count);
  const XXH128_hash_t value = digest.value();
  return {value.high64, value.low64};
}

}  // namespace

void seal(const std::string& path) {
  DiskFile file(path, DiskFile::Mode::Change);
  Seal mark{magic, format, file.length(), {}};
  mark.checksum = checksum(file, mark);
  file.seek(0);
  file.write(&mark, sizeof(mark));
  file.give_back();
  file.sync();
}

std::string seal_problem(const std::string& path) {
  try {
    DiskFile file(path, DiskFile::Mode::Read);
    Seal mark{};
    if (file.read(&mark, sizeof(mark)) < sizeof(mark) || mark.magic != magic) return "is not a checkpoint of Ixos";
    if (mark.format != format)
      return fmt::format("is a checkpoint of format {}, and this version reads format {}", mark.format, format);
    if (mark.length != file.length())
      return fmt::format("is damaged: it has {} bytes, and was written with {}", file.length(), mark.length);
    if (mark.checksum != checksum(file, mark)) return "is damaged: its checksum does not fit its contents";
    return "";
  } catch (const FileError& error) {
    // The file's name comes before already.
    return std::string(error.what()).substr(path.size() + 2);
  }
}

}  // namespace ixos
