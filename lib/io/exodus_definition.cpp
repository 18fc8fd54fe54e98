#include "io/exodus_definition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <string>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "io/disk_file.hpp"

namespace ixos {
namespace {

/// Returns the system's message for an error. NetCDF's positive error numbers are the system's. If Exodus lost the
/// number, errno may still have it; other values of errno are leftovers.
std::string system_word() {
  const char *message = nullptr, *function = nullptr;
  int number = 0;
  ex_get_err(&message, &function, &number);
  if (number > 0) return std::string(": ") + std::strerror(number);
  for (int word : {ENOSPC, EFBIG, EDQUOT, EROFS, EIO})
    if (errno == word) return std::string(": ") + std::strerror(word);
  return "";
}

/// Throws std::logic_error for enriched cells, which pictures have in pieces.
const char* topology(CellType type) {
  const CellInfo& info = cell_info(type);
  if (info.exodus.empty()) throw std::logic_error("Exodus has no such cells: " + std::string(info.name));
  return info.exodus.data();
}

void put_blocks(const ExodusHandle& file, const Mesh& mesh) {
  int id = 0;
  for (const ElementBlock& block : mesh.blocks) {
    ++id;
    require_written(
        ex_put_block(file, EX_ELEM_BLOCK, id, topology(block.type), block.cells(), nodes_per_cell(block.type), 0, 0, 0),
        file, "a block");
    require_written(ex_put_name(file, EX_ELEM_BLOCK, id, block.name.c_str()), file, "a block's name");
    if (block.nodes.empty()) continue;
    std::vector<int> nodes(block.nodes);
    for (int& node : nodes) ++node;
    require_written(ex_put_conn(file, EX_ELEM_BLOCK, id, nodes.data(), nullptr, nullptr), file, "connectivity");
  }
}

void put_sets(const ExodusHandle& file, const Mesh& mesh) {
  int id = 0;
  for (const NodeSet& set : mesh.node_sets) {
    ++id;
    std::vector<int> nodes(set.nodes);
    for (int& node : nodes) ++node;
    require_written(ex_put_set_param(file, EX_NODE_SET, id, static_cast<int64_t>(nodes.size()), 0), file, "a node set");
    require_written(ex_put_name(file, EX_NODE_SET, id, set.name.c_str()), file, "a node set's name");
    if (!nodes.empty()) require_written(ex_put_set(file, EX_NODE_SET, id, nodes.data(), nullptr), file, "a node set");
  }
  std::vector<int> first{1};
  for (const ElementBlock& block : mesh.blocks) first.push_back(first.back() + block.cells());
  id = 0;
  for (const SideSet& set : mesh.side_sets) {
    ++id;
    std::vector<int> cells, sides;
    for (const Side& side : set.sides) {
      cells.push_back(first[static_cast<std::size_t>(side.block)] + side.cell);
      sides.push_back(side.side + 1);
    }
    require_written(ex_put_set_param(file, EX_SIDE_SET, id, static_cast<int64_t>(cells.size()), 0), file, "a side set");
    require_written(ex_put_name(file, EX_SIDE_SET, id, set.name.c_str()), file, "a side set's name");
    if (!cells.empty())
      require_written(ex_put_set(file, EX_SIDE_SET, id, cells.data(), sides.data()), file, "a side set");
  }
}

void put_information(const ExodusHandle& file, const std::vector<std::string>& lines) {
  const std::vector<std::string> records = exodus_records(lines);
  std::vector<char*> words;
  words.reserve(records.size());
  for (const std::string& record : records) words.push_back(const_cast<char*>(record.c_str()));
  if (!words.empty())
    require_written(ex_put_info(file, static_cast<int>(words.size()), words.data()), file, "information records");
}

/// Writes the description that ParaView needs to join the files of a series.
void put_share(const ExodusHandle& file, const Mesh& mesh, const ExodusShare& share) {
  char kind[] = "p";
  require_written(ex_put_init_info(file, share.ranks, 1, kind), file, "the series");
  require_written(
      ex_put_init_global(file, share.global_nodes, share.global_cells, static_cast<int64_t>(mesh.blocks.size()),
                         static_cast<int64_t>(mesh.node_sets.size()), static_cast<int64_t>(mesh.side_sets.size())),
      file, "the series");
  std::vector<int> ids(mesh.blocks.size());
  std::iota(ids.begin(), ids.end(), 1);
  require_written(ex_put_eb_info_global(file, ids.data(), const_cast<int*>(share.global_block_cells.data())), file,
                  "the series");
}

}  // namespace

void require_written(int status, const ExodusHandle& file, const char* what) {
  if (status < 0) throw FileError(fmt::format("{}: {} cannot be written{}", file.path(), what, system_word()));
}

void require_created(int status, const std::string& path) {
  const bool refused = errno == EACCES || errno == ENOENT;
  if (status < 0)
    throw FileError(fmt::format("{}: cannot be written{}", path,
                                refused ? std::string(": ") + std::strerror(errno) : system_word()));
}

int create_exodus(const std::string& path, ExodusFormat format) {
  int word = 8, stored = 8;
  remove_link(path);
  errno = 0;
  const int kind = format == ExodusFormat::Hdf5 ? EX_NETCDF4 : EX_LARGE_MODEL;
  return ex_create(path.c_str(), EX_CLOBBER | kind, &word, &stored);
}

std::vector<std::string> exodus_records(const std::vector<std::string>& lines) {
  std::vector<std::string> records;
  for (const std::string& line : lines) {
    std::size_t start = 0;
    do {
      const std::string indent = start == 0 ? "" : "  ";
      std::size_t end = std::min(line.size(), start + MAX_LINE_LENGTH - indent.size());
      while (end < line.size() && end > start + 1 && (static_cast<unsigned char>(line[end]) & 0xc0U) == 0x80U)
        --end;  // not inside a character of UTF-8
      records.push_back(indent + line.substr(start, end - start));
      start = end;
    } while (start < line.size());
  }
  return records;
}

void define_exodus_mesh(const ExodusHandle& file, const Mesh& mesh, const ExodusShare& share, const std::string& title,
                        const std::vector<std::string>& information) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  ex_set_max_name_length(file, most_name_length);
  require_written(ex_put_init(file, title.substr(0, MAX_LINE_LENGTH).c_str(), mesh.dimension, mesh.nodes(),
                              mesh.cells(), static_cast<int64_t>(mesh.blocks.size()),
                              static_cast<int64_t>(mesh.node_sets.size()), static_cast<int64_t>(mesh.side_sets.size())),
                  file, "the header");
  put_information(file, information);
  if (share.ranks > 1) put_share(file, mesh, share);
  std::array<std::vector<double>, 3> axes;
  for (std::size_t i = 0; i < mesh.coordinates.size(); ++i) axes[i % d].push_back(mesh.coordinates[i]);
  require_written(ex_put_coord(file, axes[0].data(), axes[1].data(), axes[2].data()), file, "coordinates");
  put_blocks(file, mesh);
  put_sets(file, mesh);
  require_written(ex_put_id_map(file, EX_NODE_MAP, share.node_ids.data()), file, "node numbers");
  require_written(ex_put_id_map(file, EX_ELEM_MAP, share.cell_ids.data()), file, "cell numbers");
}

}  // namespace ixos
