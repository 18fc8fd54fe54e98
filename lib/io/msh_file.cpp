#include "io/msh_file.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <utility>

#include "io/msh2_sections.hpp"
#include "io/msh_nodes.hpp"

namespace ixos {
namespace {

class Reader {
 public:
  explicit Reader(MshSource source) : source_(std::move(source)) { file_.length = source_.length(); }

  MshFile read() {
    std::string first = source_.next_section();
    for (; first == "Comments"; first = source_.next_section()) source_.skip_section();
    if (first != "MeshFormat") source_.refuse_file("is not a mesh of gmsh: it begins otherwise");
    read_format();
    std::set<std::string> seen;
    for (std::string name = source_.next_section(); !name.empty(); name = source_.next_section()) {
      if (is_read(name) && !seen.insert(name).second) source_.refuse("${} is given twice", name);
      if (name == "Elements" && seen.count("Nodes") == 0) source_.refuse("$Elements stands before $Nodes");
      if (name == "PartitionedEntities")
        source_.refuse("the mesh is partitioned; save it without partitions: Ixos makes its own");
      read_section(name);
    }
    for (const char* name : {"Nodes", "Elements"})
      if (seen.count(name) == 0) source_.refuse_file("has no section ${}: there is no mesh, or it is truncated", name);
    return std::move(file_);
  }

 private:
  static bool is_read(const std::string& name) {
    return name == "PhysicalNames" || name == "Entities" || name == "Nodes" || name == "Elements";
  }

  void read_section(const std::string& name) {
    if (!is_read(name)) return source_.skip_section();
    if (name == "PhysicalNames") read_names();
    if (name == "Entities") read_entities();
    if (name == "Nodes") second_ ? read_msh2_nodes(source_, binary_, file_, nodes_) : read_nodes();
    if (name == "Elements") second_ ? read_msh2_elements(source_, binary_, nodes_, file_) : read_elements();
    source_.end_section();
  }

  void read_format() {
    const std::string version(source_.word("the version"));
    second_ = version == "2.2" || version == "2";
    if (version != "4.1" && !second_)
      source_.refuse(
          "the format is MSH {}; 4.1 and 2.2 are allowed. Convert the file with: gmsh OLD.msh -save -format msh41 -o "
          "NEW.msh",
          version.substr(0, 10));
    const std::int64_t mode = source_.integer("the mode");
    if (mode != 0 && mode != 1) source_.refuse("the mode is {}; 0 (ASCII) and 1 (binary) are allowed", mode);
    const char* const measured = second_ ? "double" : "size_t";
    const std::int64_t bytes = source_.integer("the size of a number");
    if (bytes != 8) source_.refuse("a {} has {} bytes; 8 are allowed", measured, bytes);
    source_.line();
    binary_ = mode == 1;
    source_.set_binary(binary_);
    if (binary_ && source_.integer("the byte order") != 1)
      source_.refuse("the byte order is that of another kind of machine; save the mesh in ASCII");
    source_.end_section();
  }

  /// This section is text in binary files too.
  void read_names() {
    source_.set_binary(false);
    const std::int64_t count = source_.integer("the number of physical names");
    for (std::int64_t k = 0; k < count; ++k) {
      const int dimension = read_dimension();
      const int tag = read_group();
      const std::string_view line = source_.line();
      const std::size_t first = line.find('"'), last = line.rfind('"');
      if (first == last) source_.refuse("the name of a physical group has to stand in quotes");
      const std::string name(line.substr(first + 1, last - first - 1));
      if (!file_.names.emplace(MshTag{dimension, tag}, name).second)
        source_.refuse("the physical group {} of dimension {} has two names", tag, dimension);
    }
    source_.set_binary(binary_);
  }

  int read_dimension() {
    const std::int64_t dimension = source_.integer("a dimension");
    if (dimension < 0 || dimension > 3) source_.refuse("a dimension is {}; 0 to 3 are allowed", dimension);
    return static_cast<int>(dimension);
  }

  /// Returns the tag of a physical group. A minus sign means a reversed orientation, which nothing here depends on.
  int read_group() {
    const std::int64_t tag = std::abs(source_.integer("the tag of a physical group"));
    if (tag == 0 || tag > INT_MAX)
      source_.refuse("the tag of a physical group is {}; 1 to {} are allowed", tag, INT_MAX);
    return static_cast<int>(tag);
  }

  void read_entities() {
    std::array<std::size_t, 4> counts{};
    for (std::size_t dimension = 0; dimension < 4; ++dimension)
      counts[dimension] = source_.count("a number of entities", {1, 1, 3});
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::size_t k = 0; k < counts[static_cast<std::size_t>(dimension)]; ++k) read_entity(dimension);
  }

  void read_entity(int dimension) {
    const auto tag = static_cast<int>(source_.integer("the tag of an entity"));
    const auto [entity, fresh] = file_.groups.emplace(MshTag{dimension, tag}, std::vector<int>());
    if (!fresh) source_.refuse("the entity {} of dimension {} is given twice", tag, dimension);
    for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) source_.number("a coordinate of an entity");
    const std::size_t groups = source_.count("the number of physical groups of an entity", {1, 0, 0});
    std::vector<int>& tags = entity->second;
    for (std::size_t k = 0; k < groups; ++k) tags.push_back(read_group());
    std::sort(tags.begin(), tags.end());
    tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
    if (dimension == 0) return;
    const std::size_t bounds = source_.count("the number of bounding entities", {1, 0, 0});
    for (std::size_t k = 0; k < bounds; ++k) source_.integer("the tag of a bounding entity");
  }

  void read_nodes() {
    const std::size_t blocks = source_.count("the number of entities with nodes", {3, 1, 0});
    const std::size_t total = source_.count("the number of nodes", {0, 1, 3});
    if (total > INT_MAX / 3) source_.refuse("there are {} nodes; {} are allowed", total, INT_MAX / 3);
    read_tag_range("node");
    nodes_.reserve(total);
    file_.coordinates.reserve(3 * total);
    for (std::size_t block = 0; block < blocks; ++block) read_nodes_of_entity(total);
    if (nodes_.size() != total) source_.refuse("the entities have {} nodes, not {}", nodes_.size(), total);
    nodes_.finish(source_);
  }

  void read_nodes_of_entity(std::size_t total) {
    const int dimension = read_dimension();
    source_.integer("the tag of an entity");
    const std::int64_t parametric = source_.integer("the mark of parametric coordinates");
    if (parametric != 0 && parametric != 1)
      source_.refuse("the mark of parametric coordinates is {}; 0 and 1 are allowed", parametric);
    const std::size_t parameters = parametric == 1 ? static_cast<std::size_t>(dimension) : 0;
    const std::size_t count = source_.count("the number of nodes of an entity", {0, 1, 3 + parameters});
    if (count > total - nodes_.size()) source_.refuse("the entities have more nodes than {}", total);
    for (std::size_t k = 0; k < count; ++k) nodes_.add(source_.size("the tag of a node"));
    for (std::size_t k = 0; k < count; ++k) {
      for (int i = 0; i < 3; ++i) file_.coordinates.push_back(source_.number("a coordinate of a node"));
      for (std::size_t i = 0; i < parameters; ++i) source_.number("a parametric coordinate of a node");
    }
  }

  void read_elements() {
    const std::size_t blocks = source_.count("the number of entities with elements", {3, 1, 0});
    const std::size_t total = source_.count("the number of elements", {0, 2, 0});
    if (total > INT_MAX / 8) source_.refuse("there are {} elements; {} are allowed", total, INT_MAX / 8);
    read_tag_range("element");
    std::size_t read = 0;
    for (std::size_t block = 0; block < blocks; ++block) read += read_elements_of_entity(total - read);
    if (read != total) source_.refuse("the entities have {} elements, not {}", read, total);
  }

  /// Returns the number of elements; at most `most` are allowed.
  std::size_t read_elements_of_entity(std::size_t most) {
    const int dimension = read_dimension();
    const auto entity = static_cast<int>(source_.integer("the tag of an entity"));
    const auto number = static_cast<int>(source_.integer("the type of elements"));
    const MshType type = msh_type(number);
    if (type.nodes == 0)
      source_.refuse(
          "elements of type {}, which is unknown; elements of first and second order are allowed (Mesh.ElementOrder = "
          "1 or 2)",
          number);
    if (type.dimension != dimension)
      source_.refuse("{} (type {}) in an entity of dimension {}", type.name, number, dimension);
    const auto nodes = static_cast<std::size_t>(type.nodes);
    const std::size_t count = source_.count("the number of elements of an entity", {0, 1 + nodes, 0});
    if (count > most) source_.refuse("the entities have more elements than $Elements claims");
    MshElements elements{dimension, entity, number, {}, {}};
    elements.tags.reserve(count);
    elements.nodes.reserve(count * nodes);
    for (std::size_t k = 0; k < count; ++k) {
      elements.tags.push_back(static_cast<long long>(source_.size("the tag of an element")));
      for (std::size_t a = 0; a < nodes; ++a)
        elements.nodes.push_back(nodes_.of_element(source_.size("a node of an element"), source_));
    }
    if (count > 0) file_.elements.push_back(std::move(elements));
    return count;
  }

  /// Tags need not be contiguous: nothing depends on the least and the largest one.
  void read_tag_range(const std::string& of) {
    for (const char* end : {"the least tag of a ", "the largest tag of a "}) source_.size((end + of).c_str());
  }

  MshSource source_;
  MshFile file_;
  MshNodes nodes_;
  bool binary_ = false, second_ = false;  ///< whether it is a file of version 2.2
};

}  // namespace

MshType msh_type(int type) {
  static const std::map<int, MshType> types{
      {1, {"lines", 2, 1}},           {2, {"triangles", 3, 2}},    {3, {"quadrilaterals", 4, 2}},
      {4, {"tetrahedra", 4, 3}},      {5, {"hexahedra", 8, 3}},    {6, {"prisms", 6, 3}},
      {7, {"pyramids", 5, 3}},        {8, {"lines", 3, 1}},        {9, {"triangles", 6, 2}},
      {10, {"quadrilaterals", 9, 2}}, {11, {"tetrahedra", 10, 3}}, {12, {"hexahedra", 27, 3}},
      {13, {"prisms", 18, 3}},        {14, {"pyramids", 14, 3}},   {15, {"points", 1, 0}},
      {16, {"quadrilaterals", 8, 2}}, {17, {"hexahedra", 20, 3}},  {18, {"prisms", 15, 3}},
      {19, {"pyramids", 13, 3}}};
  const auto found = types.find(type);
  return found == types.end() ? MshType{"", 0, 0} : found->second;
}

MshFile read_msh_file(MshSource source) { return Reader(std::move(source)).read(); }

}  // namespace ixos
