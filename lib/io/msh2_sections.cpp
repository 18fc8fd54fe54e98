#include "io/msh2_sections.hpp"

#include <climits>
#include <cstdlib>
#include <map>
#include <utility>

namespace ixos {
namespace {

/// Reads the number of entries, which is text in binary files too.
std::size_t read_count(MshSource& source, bool binary, const char* what, const MshSource::Entry& entry) {
  source.set_binary(false);
  const std::size_t count = source.count(what, entry);
  source.line();
  source.set_binary(binary);
  return count;
}

std::uint64_t positive(MshSource& source, const char* what) {
  const std::int64_t number = source.integer(what);
  if (number < 1) source.refuse("{} is {}; 1 and more are allowed", what, number);
  return static_cast<std::uint64_t>(number);
}

/// Adds elements to those of their group and type.
class Elements {
 public:
  Elements(MshSource& source, const MshNodes& nodes, MshFile& file) : source_(source), nodes_(nodes), file_(file) {}

  /// Reads the rest of an element: its tags and nodes.
  void read(std::uint64_t number, int type_number, std::int64_t tags) {
    const MshType type = msh_type(type_number);
    if (type.nodes == 0)
      source_.refuse(
          "elements of type {}, which is unknown; elements of first and second order are allowed (Mesh.ElementOrder = "
          "1 "
          "or 2)",
          type_number);
    if (tags < 0 || tags > 1000) source_.refuse("an element has {} tags; 0 to 1000 are allowed", tags);
    int group = 0;
    for (std::int64_t k = 0; k < tags; ++k)
      if (const std::int64_t tag = source_.integer("a tag of an element"); k == 0)
        group = static_cast<int>(std::abs(tag) > INT_MAX ? 0 : std::abs(tag));
    MshElements& own = of(group, type_number, type.dimension);
    own.tags.push_back(static_cast<long long>(number));
    for (int a = 0; a < type.nodes; ++a)
      own.nodes.push_back(nodes_.of_element(positive(source_, "a node of an element"), source_));
  }

 private:
  MshElements& of(int group, int type, int dimension) {
    const auto [found, fresh] = place_.emplace(std::pair(group, type), file_.elements.size());
    if (fresh) {
      file_.elements.push_back({dimension, group, type, {}, {}});
      file_.groups[{dimension, group}] = group == 0 ? std::vector<int>() : std::vector<int>{group};
    }
    return file_.elements[found->second];
  }

  MshSource& source_;
  const MshNodes& nodes_;
  MshFile& file_;
  std::map<std::pair<int, int>, std::size_t> place_;
};

}  // namespace

void read_msh2_nodes(MshSource& source, bool binary, MshFile& file, MshNodes& nodes) {
  const std::size_t count = read_count(source, binary, "the number of nodes", {1, 0, 3});
  if (count > INT_MAX / 3) source.refuse("there are {} nodes; {} are allowed", count, INT_MAX / 3);
  nodes.reserve(count);
  file.coordinates.reserve(3 * count);
  for (std::size_t k = 0; k < count; ++k) {
    nodes.add(positive(source, "the number of a node"));
    for (int i = 0; i < 3; ++i) file.coordinates.push_back(source.number("a coordinate of a node"));
  }
  nodes.finish(source);
}

void read_msh2_elements(MshSource& source, bool binary, const MshNodes& nodes, MshFile& file) {
  const std::size_t count = read_count(source, binary, "the number of elements", {2, 0, 0});
  if (count > INT_MAX / 8) source.refuse("there are {} elements; {} are allowed", count, INT_MAX / 8);
  Elements elements(source, nodes, file);
  for (std::size_t read = 0; read < count;) {
    if (!binary) {
      const std::uint64_t number = positive(source, "the number of an element");
      const auto type = static_cast<int>(source.integer("the type of an element"));
      elements.read(number, type, source.integer("the number of an element's tags"));
      ++read;
      continue;
    }
    const auto type = static_cast<int>(source.integer("the type of elements"));
    const std::int64_t alike = source.integer("the number of elements of a type");
    const std::int64_t tags = source.integer("the number of an element's tags");
    if (alike < 1 || static_cast<std::uint64_t>(alike) > count - read)
      source.refuse("{} elements of a type are claimed, {} are left", alike, count - read);
    for (std::int64_t k = 0; k < alike; ++k) elements.read(positive(source, "the number of an element"), type, tags);
    read += static_cast<std::size_t>(alike);
  }
}

}  // namespace ixos
