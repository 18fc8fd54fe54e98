// Reading meshes from Exodus files.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <climits>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <utility>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "io/disk_file.hpp"
#include "io/exodus_handle.hpp"
#include "io/exodus_mesh.hpp"
#include "io/exodus_shapes.hpp"
#include "io/exodus_topology.hpp"
#include "io/exodus_values.hpp"
#include "io/file_cells.hpp"
#include "io/guarded.hpp"
#include "io/hdf5_handle.hpp"
#include "mesh/normalize.hpp"
#include "mesh/turned_cells.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {
namespace {

template <class... Values>
[[noreturn]] void refuse(const std::string& path, fmt::format_string<Values...> text, Values&&... values) {
  throw InputError(path + ": " + fmt::format(text, std::forward<Values>(values)...));
}

/// NetCDF's three formats begin with CDF or with HDF5's signature; other files do not reach the library.
void check_start(const std::string& path) {
  if (!is_file(path)) refuse(path, "the mesh file cannot be read");
  std::ifstream file(path, std::ios::binary);
  char start[4] = {};
  if (!file) refuse(path, "the mesh file cannot be read");
  file.read(start, 4);
  const std::string magic(start, 4);
  if (magic.rfind("CDF", 0) != 0 && magic != "\x89HDF") refuse(path, "is not an Exodus file");
}

int open_checked(const std::string& path) {
  check_start(path);
  hdf5::prepare();
  int word = 8, stored = 0;
  float version = 0;
  const int id = ex_open(path.c_str(), EX_READ, &word, &stored, &version);
  if (id < 0) refuse(path, "is not an Exodus file, or it is damaged");
  return id;
}

class Reader {
 public:
  explicit Reader(const std::string& path) : file_(open_checked(path), path) {
    ex_set_max_name_length(file_, name_length);
    ex_set_int64_status(file_, EX_IDS_INT64_API | EX_MAPS_INT64_API);  // ids and numbers of 64 bits
    require(ex_get_init_ext(file_, &header_), "the header");
    // Compression gains a factor of a few hundred at most; sizes beyond that are nonsense, not a reason to allocate.
    most_ = 10 * static_cast<int64_t>(std::filesystem::file_size(path));
  }

  Mesh read() {
    if (header_.num_dim != 2 && header_.num_dim != 3)
      refuse(path(), "has {} dimensions; 2 and 3 are allowed", header_.num_dim);
    if (header_.num_nodes < 1 || header_.num_elem < 1) refuse(path(), "has no nodes or no elements");
    if (header_.num_nodes > most_ || header_.num_elem > most_)
      refuse(path(), "is damaged: it claims {} nodes and {} elements", header_.num_nodes, header_.num_elem);
    if (header_.num_nodes > INT_MAX / 3 || header_.num_elem > INT_MAX / 8)
      refuse(path(), "has {} nodes and {} elements; up to {} nodes and {} elements are allowed", header_.num_nodes,
             header_.num_elem, INT_MAX / 3, INT_MAX / 8);
    check_exodus_shapes(file_, header_, most_);
    mesh_.dimension = static_cast<int>(header_.num_dim);
    read_coordinates();
    read_block_headers();
    read_blocks();
    read_node_sets();
    added_ = cells_->finish();
    read_side_sets();
    numbers(EX_NODE_MAP, header_.num_nodes, "node");
    number_cells(numbers(EX_ELEM_MAP, header_.num_elem, "element"));
    node_ = drop_unused_nodes(mesh_);
    if (mesh_.dimension > cell_dimension_) flatten_faces();
    turn_cells(mesh_);
    return std::move(mesh_);
  }

  /// Returns the values of a nodal variable by node of the mesh that read() returned.
  std::vector<double> values(const std::string& name) const {
    std::vector<double> all = last_nodal_values(file_, name, header_.num_nodes);
    for (const Middles::Sum& sum : added_) {
      double value = 0;
      for (const auto& [node, weight] : sum.weights) value += weight * all[static_cast<std::size_t>(node)];
      all.push_back(value);
    }
    std::vector<double> result;
    for (int node : node_) result.push_back(all[static_cast<std::size_t>(node)]);
    return result;
  }

 private:
  static constexpr int name_length = 255;

  const std::string& path() const { return file_.path(); }

  void require(int status, const char* what) const {
    if (status < 0) refuse(path(), "{} cannot be read: the file is damaged", what);
  }

  void read_coordinates() {
    const auto n = static_cast<std::size_t>(header_.num_nodes);
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    std::array<std::vector<double>, 3> axes{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
    require(ex_get_coord(file_, axes[0].data(), axes[1].data(), axes[2].data()), "the coordinates");
    for (std::size_t node = 0; node < n; ++node)
      for (std::size_t i = 0; i < d; ++i) {
        if (!std::isfinite(axes[i][node])) refuse(path(), "node {} has a coordinate that is not finite", node + 1);
        mesh_.coordinates.push_back(axes[i][node]);
      }
  }

  /// Returns the ids of all objects of a kind, each given once.
  std::vector<int64_t> ids(ex_entity_type type, int64_t count, const char* what) const {
    if (count > most_) refuse(path(), "is damaged: it claims {} {}s", count, what);
    std::vector<int64_t> result(static_cast<std::size_t>(std::max<int64_t>(count, 0)));
    if (result.empty()) return result;
    require(ex_get_ids(file_, type, result.data()), what);
    const std::set<int64_t> distinct(result.begin(), result.end());
    if (distinct.size() != result.size()) refuse(path(), "two {}s have the same id", what);
    return result;
  }

  /// Returns the object's name, or prefix_id; each name given once.
  std::string name(ex_entity_type type, int64_t id, const char* prefix, std::set<std::string>& taken) const {
    std::vector<char> text(name_length + 1, '\0');
    ex_get_name(file_, type, id, text.data());
    std::string result(text.data());
    if (result.empty()) result = fmt::format("{}_{}", prefix, id);
    if (!taken.insert(result).second) refuse(path(), "the name \"{}\" is given twice", result);
    return result;
  }

  /// Reads what the blocks are. The cells of the mesh are those of the highest dimension.
  void read_block_headers() {
    std::set<std::string> taken;
    int64_t cells = 0;
    for (const int64_t id : ids(EX_ELEM_BLOCK, header_.num_elem_blk, "block")) {
      ex_block block{};
      block.id = id;
      block.type = EX_ELEM_BLOCK;
      require(ex_get_block_param(file_, &block), "a block");
      ExodusBlock here{id, name(EX_ELEM_BLOCK, id, "block", taken), block.topology, block.num_entry,
                       block.num_nodes_per_entry};
      std::transform(here.topology.begin(), here.topology.end(), here.topology.begin(),
                     [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
      first_cell_.push_back(cells);
      cells += here.cells;
      if (here.cells < 0 || cells > header_.num_elem) refuse(path(), "its blocks hold more elements than it has");
      if (here.cells > 0) cell_dimension_ = std::max(cell_dimension_, dimension_of(here, mesh_.dimension));
      blocks_.push_back(std::move(here));
    }
    if (cells != header_.num_elem) refuse(path(), "its blocks hold {} elements, not {}", cells, header_.num_elem);
  }

  void read_blocks() {
    std::vector<std::string> left_out;
    check_exodus_cells(file_, static_cast<int64_t>(blocks_.size()));
    FileCellReader& reader = cells_.emplace(mesh_);
    for (const ExodusBlock& block : blocks_) {
      const bool kept = dimension_of(block, mesh_.dimension) >= cell_dimension_;
      if (!kept && is_shell(block) && block.cells > 0)
        refuse(path(),
               "block \"{}\" has shells ({}) beside cells of a volume, and Ixos has no shells: mesh this part's "
               "volume, or leave the block out of the file; surfaces on which something acts are side sets",
               block.name, block.topology);
      ElementBlock here{block.name, cube_type(cell_dimension_), {}};
      if (kept && block.cells > 0) {
        const FileCells& cells = at(path(), [&]() -> const FileCells& { return cells_of(block, mesh_.dimension); });
        here.type = cells.type;
        reader.add(cells, read_nodes(block), here);
      }
      block_place_.push_back(kept ? static_cast<int>(mesh_.blocks.size()) : -1);
      if (kept)
        mesh_.blocks.push_back(std::move(here));
      else
        left_out.push_back(block.name);
    }
    if (!left_out.empty())
      mesh_.notes.push_back("the mesh's blocks of points, lines or faces are left out: " + quoted_list(left_out));
  }

  /// Returns the nodes of a block's elements, from 0.
  std::vector<int> read_nodes(const ExodusBlock& block) const {
    if (block.cells == 0) return {};
    if (block.nodes_per_cell < 1 || block.nodes_per_cell > std::min<int64_t>(most_, INT_MAX) / block.cells)
      refuse(path(), "is damaged: block \"{}\" claims {} nodes per element", block.name, block.nodes_per_cell);
    std::vector<int> nodes(static_cast<std::size_t>(block.cells * block.nodes_per_cell));
    require(ex_get_conn(file_, EX_ELEM_BLOCK, block.id, nodes.data(), nullptr, nullptr), "connectivity");
    for (int& node : nodes) {
      if (node == 0) refuse(path(), "block \"{}\" refers to node 0: the file seems to be truncated", block.name);
      if (node < 1 || node > header_.num_nodes)
        refuse(path(), "block \"{}\" refers to node {}, but there are {}", block.name, node, header_.num_nodes);
      --node;
    }
    return nodes;
  }

  /// Returns the entries of a set, and for side sets the side numbers.
  std::vector<int> read_set(ex_entity_type type, int64_t id, int64_t largest, const std::string& set_name,
                            std::vector<int>* extra) {
    ex_set set{};
    set.id = id;
    set.type = type;
    require(ex_get_sets(file_, 1, &set), "a set");
    const int64_t count = set.num_entry;
    if (count < 0 || count > most_ - set_entries_)
      refuse(path(), "is damaged: its sets up to \"{}\" claim {} entries", set_name, set_entries_ + count);
    set_entries_ += count;
    std::vector<int> entries(static_cast<std::size_t>(count));
    if (extra != nullptr) extra->resize(entries.size());
    if (!entries.empty())
      require(ex_get_set(file_, type, id, entries.data(), extra == nullptr ? nullptr : extra->data()), "a set");
    for (int entry : entries)
      if (entry < 1 || entry > largest)
        refuse(path(), "set \"{}\" refers to number {}, but there are {}", set_name, entry, largest);
    return entries;
  }

  void read_node_sets() {
    std::set<std::string> taken;
    for (const int64_t id : ids(EX_NODE_SET, header_.num_node_sets, "node set")) {
      NodeSet set{name(EX_NODE_SET, id, "nodelist", taken), {}};
      set.nodes = read_set(EX_NODE_SET, id, header_.num_nodes, set.name, nullptr);
      for (int& node : set.nodes) --node;
      std::sort(set.nodes.begin(), set.nodes.end());
      set.nodes.erase(std::unique(set.nodes.begin(), set.nodes.end()), set.nodes.end());
      mesh_.node_sets.push_back(std::move(set));
    }
  }

  void read_side_sets() {
    std::set<std::string> taken;
    for (const int64_t id : ids(EX_SIDE_SET, header_.num_side_sets, "side set")) {
      SideSet set{name(EX_SIDE_SET, id, "surface", taken), {}};
      std::vector<int> sides;
      const std::vector<int> cells = read_set(EX_SIDE_SET, id, header_.num_elem, set.name, &sides);
      std::set<std::pair<int, int>> distinct;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const int cell = cells[i] - 1;
        const auto after = std::upper_bound(first_cell_.begin(), first_cell_.end(), cell);
        const auto place = static_cast<std::size_t>(after - first_cell_.begin()) - 1;
        const int block = block_place_[place];
        if (block < 0)
          refuse(path(), "side set \"{}\" refers to element {} of block \"{}\", which is no cell of the mesh", set.name,
                 cell + 1, blocks_[place].name);
        const CellType type = mesh_.blocks[static_cast<std::size_t>(block)].type;
        const int first = first_edge(blocks_[place], static_cast<int>(header_.num_dim));
        if (sides[i] <= first || sides[i] > first + sides_per_cell(type))
          refuse(path(), "side set \"{}\" refers to side {} of element {}; sides {} to {} are allowed", set.name,
                 sides[i], cell + 1, first + 1, first + sides_per_cell(type));
        if (!distinct.insert({cell, sides[i]}).second)
          refuse(path(), "side set \"{}\" holds side {} of element {} twice", set.name, sides[i], cell + 1);
        set.sides.push_back({block, static_cast<int>(cell - first_cell_[place]), sides[i] - 1 - first});
      }
      mesh_.side_sets.push_back(std::move(set));
    }
  }

  /// Returns the numbers that the file gives its nodes or elements: 1, 2, ... without a map. Each is given once.
  std::vector<int64_t> numbers(ex_entity_type type, int64_t count, const char* what) const {
    std::vector<int64_t> result(static_cast<std::size_t>(count));
    if (ex_get_id_map(file_, type, result.data()) < 0) return {};
    std::vector<int64_t> sorted(result);
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) refuse(path(), "{} number {} is given twice", what, *twice);
    return result;
  }

  void number_cells(const std::vector<int64_t>& given) {
    for (std::size_t place = 0; place < blocks_.size() && !given.empty(); ++place) {
      if (block_place_[place] < 0) continue;
      const auto first = given.begin() + first_cell_[place];
      mesh_.blocks[static_cast<std::size_t>(block_place_[place])].file_numbers.assign(first,
                                                                                      first + blocks_[place].cells);
    }
  }

  void flatten_faces() {
    const bool shells = std::any_of(blocks_.begin(), blocks_.end(), is_shell);
    try {
      flatten(mesh_);
    } catch (const InputError& error) {
      refuse(path(), "{}{}", error.what(), shells ? ". Ixos has no shells in space: mesh the volume of the body" : "");
    }
  }

  ExodusHandle file_;
  ex_init_params header_{};
  int64_t most_ = 0;         ///< entries of any kind that a file of this length may have
  int64_t set_entries_ = 0;  ///< of the sets read so far, together
  Mesh mesh_;
  std::optional<FileCellReader> cells_;
  std::vector<Middles::Sum> added_;  ///< nodes behind those of the file, in their order
  std::vector<int> node_;            ///< by node of the mesh: its number in the file, from 0
  int cell_dimension_ = 0;
  std::vector<ExodusBlock> blocks_;
  std::vector<int64_t> first_cell_;  ///< number of each block's first cell
  std::vector<int> block_place_;     ///< of each block in the mesh; -1: left out
};

}  // namespace

Mesh read_exodus_mesh(const std::string& path) {
  check_start(path);
  try_reading(path, [&] { read_tried_exodus_mesh(path); });
  return read_tried_exodus_mesh(path);
}

Mesh read_tried_exodus_mesh(const std::string& path) { return Reader(path).read(); }

std::vector<double> read_exodus_field(const std::string& path, const std::string& name) {
  check_start(path);
  try_reading(path, [&] { read_tried_exodus_field(path, name); });
  return read_tried_exodus_field(path, name);
}

std::vector<double> read_tried_exodus_field(const std::string& path, const std::string& name) {
  Reader reader(path);
  reader.read();
  return reader.values(name);
}

}  // namespace ixos
