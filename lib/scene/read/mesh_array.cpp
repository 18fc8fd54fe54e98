#include "scene/read/mesh_array.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/counted_random.hpp"
#include "base/digest.hpp"
#include "interaction/direction.hpp"
#include "mesh/cell_place.hpp"
#include "mesh/overlaps.hpp"
#include "mesh/placement.hpp"
#include "mesh/repeated.hpp"
#include "parameters/parameter_entries.hpp"
#include "scene/read/array_options.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;
using Triple = std::array<double, 3>;

/// A copy, before its disorder.
struct Copy {
  Triple place{};    ///< [L0]
  double angle = 0;  ///< about the last axis [degrees]
  double scale = 1;
};

std::vector<Copy> grid_copies(const SceneNode& node, const ArrayGrid& grid, std::size_t dimension) {
  const std::size_t directions = dimension - 1;
  for (const auto& [name, size] : {std::pair{"Counts", grid.counts.size()}, {"Spacing", grid.spacing.size()}})
    if (size != directions)
      node.refuse(name,
                  fmt::format("it has {} numbers; a mesh of {} dimensions takes {}", size, dimension, directions));
  const int rows = directions == 2 ? grid.counts[1] : 1;
  std::vector<Copy> copies;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < grid.counts[0]; ++i) {
      Copy copy;
      const double shift = j % 2 == 1 ? grid.stagger : 0;
      copy.place[0] = (i - (grid.counts[0] - 1) / 2.0 + shift) * grid.spacing[0];
      if (directions == 2) copy.place[1] = (j - (rows - 1) / 2.0) * grid.spacing[1];
      copies.push_back(copy);
    }
  return copies;
}

std::vector<Copy> ring_copies(const ArrayRing& ring) {
  std::vector<Copy> copies;
  for (int i = 0; i < ring.count; ++i) {
    const double angle = 360.0 * i / ring.count, radians = angle * M_PI / 180;
    copies.push_back({{ring.radius * std::cos(radians), ring.radius * std::sin(radians), 0}, ring.turn ? angle : 0, 1});
  }
  return copies;
}

std::vector<Copy> table_copies(const SceneNode& node, const ArrayPlaces& table, std::size_t dimension) {
  const std::size_t count = table.places.size() / dimension;
  if (table.places.empty() || table.places.size() % dimension != 0)
    node.refuse("Places", fmt::format("it has {} numbers; give {} for each copy", table.places.size(), dimension));
  for (const auto& [name, values] : {std::pair{"Angles", &table.angles}, {"Scales", &table.scales}})
    if (!values->empty() && values->size() != count)
      node.refuse(name, fmt::format("it has {} numbers; Places has {} copies", values->size(), count));
  std::vector<Copy> copies(count);
  for (std::size_t k = 0; k < count; ++k) {
    std::copy_n(&table.places[k * dimension], dimension, copies[k].place.begin());
    if (!table.angles.empty()) copies[k].angle = table.angles[k];
    if (!table.scales.empty()) copies[k].scale = table.scales[k];
  }
  return copies;
}

/// Returns at least the number of copies.
double count_of(const ArrayOptions& array) {
  if (array.layout == ArrayLayout::Ring) return array.ring.count;
  if (array.layout == ArrayLayout::Table) return static_cast<double>(array.table.places.size());
  double count = 1;
  for (const int many : array.grid.counts) count *= many;
  return count;
}

std::vector<Copy> copies_of(const SceneNode& part, const ArrayOptions& array, std::size_t dimension) {
  switch (array.layout) {
    case ArrayLayout::Grid:
      return grid_copies(part.sublist("Grid"), array.grid, dimension);
    case ArrayLayout::Ring:
      return ring_copies(array.ring);
    case ArrayLayout::Table:
      return table_copies(part.sublist("Table"), array.table, dimension);
    case ArrayLayout::Once:
      break;
  }
  return {};
}

/// The random numbers of a copy.
class Chance {
 public:
  Chance(const ArrayDisorder& disorder, std::size_t copy) : disorder_(disorder), copy_(copy) {}

  /// Returns amount times a number between -1 and 1, or of deviation 1; each `number` is another one.
  double amount(double amount, std::uint64_t number) const {
    if (amount == 0) return 0;
    const auto seed = static_cast<std::uint64_t>(disorder_.seed);
    return amount *
           (disorder_.normal ? counted_normal(seed, copy_, number) : 2 * counted_random(seed, copy_, number) - 1);
  }
  /// Returns an angle [radians], any as likely.
  double direction(std::uint64_t number) const {
    return 2 * M_PI * counted_random(static_cast<std::uint64_t>(disorder_.seed), copy_, number);
  }

 private:
  const ArrayDisorder& disorder_;
  std::uint64_t copy_;
};

// The numbers of a copy. A normal number n takes the random ones 2n and 2n + 1.
constexpr std::uint64_t of_place = 0, of_angle = 3, of_inclination = 4, of_scale = 5, of_azimuth = 100;

/// Returns the first number of a parameter, from its path alone, so that no other amount changes it. Those of arrays
/// follow each other.
std::uint64_t of_parameter(const std::string& path) { return (checksum(path.data(), path.size())[0] >> 8U) + 1000; }

/// Changes the numbers of a part's list for a copy, by the amounts of a list of the same structure. `path`: of that.
void change_parameters(const SceneNode& part, const List& amounts, const std::string& path, const Chance& chance,
                       List& list) {
  for (const auto& [name, entry] : entries(amounts)) {
    std::string place = path;
    place.append("/").append(name);
    if (entry.isList()) {
      if (!list.isSublist(name)) part.refuse(place, "the part has no list of that name");
      change_parameters(part, amounts.sublist(name), place, chance, list.sublist(name));
      continue;
    }
    const double amount = entry.isType<double>() ? Teuchos::getValue<double>(entry) : -1;
    if (!(amount >= 0) || !std::isfinite(amount)) part.refuse(place, "an amount is a real number, at least 0");
    std::uint64_t number = of_parameter(place);
    if (list.isType<double>(name))
      list.get<double>(name) *= 1 + chance.amount(amount, number);
    else if (list.isType<Teuchos::Array<double>>(name))
      for (double& value : list.get<Teuchos::Array<double>>(name)) value *= 1 + chance.amount(amount, number++);
    else
      part.refuse(place, "the part has no real number of that name");
  }
}

List changed_list(const SceneNode& part, const ArrayDisorder& disorder, const Chance& chance) {
  List list(part.list());
  change_parameters(part, disorder.parameters, "Disorder/Parameters", chance, list);
  return list;
}

bool is_empty(const List& list) { return list.begin() == list.end(); }

/// Refuses disorder that would do nothing, and lists that say where copies stand.
void check_disorder(const SceneNode& part, const ArrayOptions& array) {
  const ArrayDisorder& own = array.disorder;
  const bool any =
      !own.place.empty() || own.angle != 0 || own.inclination != 0 || own.scale != 0 || !is_empty(own.parameters);
  if (array.layout == ArrayLayout::Once && any)
    part.refuse("Disorder", "a part of the Layout Once has no copies that could differ; choose another Layout");
  for (const char* const name : {"Grid", "Ring", "Table", "Disorder", "Sets", "Exodus", "Gmsh"})
    if (own.parameters.isSublist(name))
      part.refuse(std::string("Disorder/Parameters/") + name, "copies can differ in the numbers of generators alone");
}

/// Scales a copy, inclines and turns it about a point, and shifts it.
void place_copy(const Copy& copy, const ArrayDisorder& disorder, const Triple& point, const Chance& chance,
                Mesh& mesh) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const double scale = copy.scale * (1 + chance.amount(disorder.scale, of_scale));
  if (!(scale > 0)) throw InputError(fmt::format("its size would have the factor {:.3g}", scale));
  for (std::size_t i = 0; i < mesh.coordinates.size(); ++i)
    mesh.coordinates[i] = point[i % d] + scale * (mesh.coordinates[i] - point[i % d]);
  if (disorder.inclination != 0) {
    const double azimuth = chance.direction(of_azimuth);
    Placement tilt;
    tilt.point = point;
    tilt.angle = chance.amount(disorder.inclination, of_inclination);
    tilt.axis = {std::cos(azimuth), std::sin(azimuth), 0};
    move_nodes(tilt, mesh);
  }
  Placement placement;
  placement.point = point;
  placement.angle = copy.angle + chance.amount(disorder.angle, of_angle);
  for (std::size_t i = 0; i < d; ++i)
    placement.translation[i] =
        copy.place[i] + (disorder.place.empty() ? 0 : chance.amount(disorder.place[i], of_place + i));
  move_nodes(placement, mesh);
}

}  // namespace

Mesh array_of(const SceneNode& part, const std::function<Mesh(const SceneNode&)>& make) {
  const ArrayOptions array = read_array(part);
  check_disorder(part, array);
  if (array.layout == ArrayLayout::Once) return make(part);
  const bool alike = is_empty(array.disorder.parameters);
  const Mesh first = make(part);
  const auto d = static_cast<std::size_t>(first.dimension);
  if (!array.disorder.place.empty() && array.disorder.place.size() != d)
    part.refuse("Disorder/Place",
                fmt::format("it has {} numbers; the mesh has {} dimensions", array.disorder.place.size(), d));
  if (d == 2 && array.disorder.inclination != 0)
    part.refuse("Disorder/Inclination", "a part of two dimensions turns about z alone: use Angle");
  changed_list(part, array.disorder, Chance(array.disorder, 1));  // refuses names that the part has not
  const Triple point = place_of(part, "Point", d);
  if (const double copies = count_of(array); copies * first.nodes() > 1e9)
    part.refuse("Layout",
                fmt::format("{:.0f} copies of {} nodes have more than 1e9 nodes together", copies, first.nodes()));
  const std::vector<Copy> copies = copies_of(part, array, d);
  std::vector<Mesh> meshes;
  meshes.reserve(copies.size());
  for (const Copy& copy : copies) {
    const std::size_t number = meshes.size() + 1;
    try {
      const Chance chance(array.disorder, number);
      if (alike) {
        meshes.push_back(first);
      } else {
        const List list = changed_list(part, array.disorder, chance);
        meshes.push_back(make(SceneNode(list, part.path(), part.name())));
      }
      place_copy(copy, array.disorder, point, chance, meshes.back());
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: copy {} (seed {}) cannot be made: {}", part.path(), number, array.disorder.seed,
                                   error.what()));
    }
  }
  std::vector<const Mesh*> all;
  all.reserve(meshes.size());
  for (const Mesh& mesh : meshes) all.push_back(&mesh);
  if (const auto overlap = find_overlap(all))
    throw InputError(fmt::format("{}: the copies {} and {} (seed {}) overlap at {}; put them farther apart",
                                 part.path(), std::min(overlap->first, overlap->second) + 1,
                                 std::max(overlap->first, overlap->second) + 1, array.disorder.seed,
                                 point_in_words(overlap->place, first.dimension)));
  return repeated(std::move(meshes));
}

}  // namespace ixos
