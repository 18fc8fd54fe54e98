#include "checkpoint/seal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/error.hpp"
#include "io/disk_file.hpp"

namespace ixos {
namespace {

constexpr std::array<char, 16> magic{'I', 'x', 'o', 's', ' ', 'c', 'h', 'e', 'c', 'k', 'p', 'o', 'i', 'n', 't', '\n'};
constexpr std::uint64_t format = 6;

/// The first bytes of the file; the rest of the user block is zero.
struct Seal {
  std::array<char, 16> magic;
  std::uint64_t format;
  std::uint64_t length;  ///< of the file
  std::uint64_t pieces;  ///< in the table at the file's end
  Checksum checksum;     ///< of this block, with 0 in place of these two words, and of the table
};
using Block = std::array<char, seal_bytes>;

std::uint64_t table_bytes(std::uint64_t pieces) { return pieces * sizeof(FilePiece); }

Block block_of(const Seal& seal) {
  Block block{};
  std::copy_n(reinterpret_cast<const char*>(&seal), sizeof(seal), block.begin());
  return block;
}

Checksum checksum_of(Seal seal, const std::vector<FilePiece>& pieces) {
  seal.checksum = {};
  const Block block = block_of(seal);
  Digest digest;
  digest.add(block.data(), block.size());
  digest.add(pieces.data(), table_bytes(pieces.size()));
  return digest.value();
}

Checksum checksum_on_disk(const DiskFile& file, std::uint64_t position, std::uint64_t length) {
  Digest digest;
  std::vector<char> buffer(std::min<std::uint64_t>(length, 1 << 20));
  while (length > 0) {
    const std::size_t count = file.read_at(position, buffer.data(), std::min<std::uint64_t>(length, buffer.size()));
    if (count == 0) break;
    digest.add(buffer.data(), count);
    position += count;
    length -= count;
  }
  return digest.value();
}

/// Whether the pieces cover the file between the seal and the table, and each has its checksum.
bool sound(const DiskFile& file, const std::vector<FilePiece>& pieces, std::uint64_t end) {
  std::uint64_t position = seal_bytes;
  for (const FilePiece& piece : pieces) {
    if (piece.position != position || piece.length > end - position) return false;
    if (checksum_on_disk(file, piece.position, piece.length) != piece.checksum) return false;
    position += piece.length;
  }
  return position == end;
}

}  // namespace

void seal(const std::string& path, std::vector<FilePiece> pieces) {
  DiskFile file(path, DiskFile::Mode::Change);
  const std::uint64_t end = pieces.empty() ? seal_bytes : pieces.back().position + pieces.back().length;
  const std::uint64_t length = end + table_bytes(pieces.size());
  Seal mark{magic, format, length, pieces.size(), {}};
  mark.checksum = checksum_of(mark, pieces);
  file.write_at(end, pieces.data(), table_bytes(pieces.size()));
  const Block block = block_of(mark);
  file.write_at(0, block.data(), block.size());
  file.set_length(length);
  file.sync();
  file.close();
}

std::string seal_problem(const std::string& path) {
  try {
    const DiskFile file(path, DiskFile::Mode::Read);
    Block block{};
    Seal mark{};
    const std::size_t read = file.read_at(0, block.data(), block.size());
    std::copy_n(block.begin(), sizeof(mark), reinterpret_cast<char*>(&mark));
    if (read < sizeof(mark) || mark.magic != magic) return "is not a checkpoint of Ixos";
    if (mark.format != format)
      return fmt::format("is a checkpoint of format {}, and this version reads format {}", mark.format, format);
    if (mark.length != file.length())
      return fmt::format("is damaged: it has {} bytes, and was written with {}", file.length(), mark.length);
    std::string damaged = "is damaged: its checksum does not fit its contents";
    if (mark.length < seal_bytes || mark.pieces > (mark.length - seal_bytes) / sizeof(FilePiece)) return damaged;
    const std::uint64_t end = mark.length - table_bytes(mark.pieces);
    std::vector<FilePiece> pieces(mark.pieces);
    file.read_at(end, pieces.data(), table_bytes(mark.pieces));
    const bool whole = mark.checksum == checksum_of(mark, pieces) && block == block_of(mark);
    return whole && sound(file, pieces, end) ? "" : damaged;
  } catch (const FileError& error) {
    // The file's name comes before already.
    return std::string(error.what()).substr(path.size() + 2);
  }
}

}  // namespace ixos
