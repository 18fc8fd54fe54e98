#include "io/field_file.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/exodus_definition.hpp"

namespace ixos {
namespace {

/// The rank's own cells as a mesh of their own.
struct Share {
  Mesh mesh;
  ExodusShare description;
  std::vector<int> nodes;               ///< local node of each node of the mesh
  std::vector<std::vector<int>> cells;  ///< by block: local cell of each cell of the mesh
};

Share own_share(const LocalMesh& local, int ranks) {
  Share share;
  share.mesh.dimension = local.dimension;
  share.description.ranks = ranks;
  share.description.global_nodes = local.global_nodes;
  share.description.global_cells = local.global_cells;
  const auto d = static_cast<std::size_t>(local.dimension);
  std::vector<int> number(static_cast<std::size_t>(local.nodes()), -1);
  std::vector<std::vector<int>> cell_number;
  int cell_offset = 0;
  for (const LocalBlock& block : local.blocks) {
    const int n = nodes_per_cell(block.type);
    ElementBlock here{block.name, block.type, {}};
    share.cells.emplace_back();
    cell_number.emplace_back(static_cast<std::size_t>(block.cells()), -1);
    for (int cell = 0; cell < block.cells(); ++cell) {
      if (block.owned[static_cast<std::size_t>(cell)] == 0) continue;
      cell_number.back()[static_cast<std::size_t>(cell)] = here.cells();
      share.cells.back().push_back(cell);
      share.description.cell_ids.push_back(cell_offset + block.original_cells[static_cast<std::size_t>(cell)] + 1);
      for (int a = 0; a < n; ++a) {
        const int node = block.nodes[cell_entry(cell, n, a)];
        int& mine = number[static_cast<std::size_t>(node)];
        if (mine < 0) {
          mine = static_cast<int>(share.nodes.size());
          share.nodes.push_back(node);
          share.description.node_ids.push_back(local.original_ids[static_cast<std::size_t>(node)] + 1);
          for (std::size_t i = 0; i < d; ++i)
            share.mesh.coordinates.push_back(local.coordinates[static_cast<std::size_t>(node) * d + i]);
        }
        here.nodes.push_back(mine);
      }
    }
    cell_offset += block.global_cells;
    share.description.global_block_cells.push_back(block.global_cells);
    share.mesh.blocks.push_back(std::move(here));
  }
  for (std::size_t s = 0; s < local.side_sets.size(); ++s) {
    share.mesh.side_sets.push_back({local.side_set_names[s], {}});
    for (const LocalSide& side : local.side_sets[s])
      if (side.owned)
        share.mesh.side_sets.back().sides.push_back(
            {side.block, cell_number[static_cast<std::size_t>(side.block)][static_cast<std::size_t>(side.cell)],
             side.side});
  }
  for (std::size_t s = 0; s < local.node_sets.size(); ++s) {
    share.mesh.node_sets.push_back({local.node_set_names[s], {}});
    for (int node : local.node_sets[s])
      if (number[static_cast<std::size_t>(node)] >= 0)
        share.mesh.node_sets.back().nodes.push_back(number[static_cast<std::size_t>(node)]);
  }
  return share;
}

int create(const std::string& path) {
  int word = 8, stored = 8;
  const int id = ex_create(path.c_str(), EX_CLOBBER | EX_LARGE_MODEL, &word, &stored);
  if (id < 0) throw FileError(path + ": cannot be written");
  return id;
}

std::string file_name(const std::string& path, int rank, int ranks) {
  if (ranks == 1) return path;
  return fmt::format("{}.{}.{:0{}}", path, ranks, rank, fmt::format("{}", ranks - 1).size());
}

void define_variables(const ExodusHandle& file, ex_entity_type type, const std::vector<std::string>& names) {
  if (names.empty()) return;
  std::vector<char*> words;
  words.reserve(names.size());
  for (const std::string& name : names) words.push_back(const_cast<char*>(name.c_str()));
  require_written(ex_put_variable_param(file, type, static_cast<int>(names.size())), file, "variables");
  require_written(ex_put_variable_names(file, type, static_cast<int>(names.size()), words.data()), file, "variables");
}

}  // namespace

struct FieldFile::Implementation {
  Implementation(const std::string& path, Share own) : file(create(path), path), share(std::move(own)) {}
  ExodusHandle file;
  Share share;
  int frame = 0;
};

FieldFile::FieldFile(const std::string& path, const LocalMesh& mesh, int rank, int ranks, const FieldNames& names,
                     const std::string& title)
    : implementation_(std::make_unique<Implementation>(file_name(path, rank, ranks), own_share(mesh, ranks))) {
  const ExodusHandle& file = implementation_->file;
  define_exodus_mesh(file, implementation_->share.mesh, implementation_->share.description, title);
  // Exodus refuses variables on nodes or cells that a file has none of: a rank may own no cells.
  if (!implementation_->share.nodes.empty()) {
    define_variables(file, EX_NODAL, names.nodal);
    define_variables(file, EX_ELEM_BLOCK, names.cell);
  }
  define_variables(file, EX_GLOBAL, names.global);
}

FieldFile::~FieldFile() = default;

void FieldFile::write(double time, const std::vector<std::vector<double>>& nodal,
                      const std::vector<std::vector<std::vector<double>>>& cell, const std::vector<double>& global) {
  const ExodusHandle& file = implementation_->file;
  const Share& share = implementation_->share;
  const int frame = ++implementation_->frame;
  require_written(ex_put_time(file, frame, &time), file, "a time");
  std::vector<double> values;
  for (std::size_t v = 0; v < nodal.size() && !share.nodes.empty(); ++v) {
    values.clear();
    for (int node : share.nodes) values.push_back(nodal[v][static_cast<std::size_t>(node)]);
    require_written(ex_put_var(file, frame, EX_NODAL, static_cast<int>(v) + 1, 1, static_cast<int64_t>(values.size()),
                               values.data()),
                    file, "a nodal field");
  }
  for (std::size_t v = 0; v < cell.size(); ++v)
    for (std::size_t b = 0; b < share.cells.size(); ++b) {
      values.clear();
      for (int c : share.cells[b]) values.push_back(cell[v][b][static_cast<std::size_t>(c)]);
      if (values.empty()) continue;
      require_written(ex_put_var(file, frame, EX_ELEM_BLOCK, static_cast<int>(v) + 1, static_cast<int64_t>(b) + 1,
                                 static_cast<int64_t>(values.size()), values.data()),
                      file, "a cell field");
    }
  if (!global.empty())
    require_written(ex_put_var(file, frame, EX_GLOBAL, 1, 0, static_cast<int64_t>(global.size()), global.data()), file,
                    "global variables");
  require_written(ex_update(file), file, "a frame");
}

}  // namespace ixos
