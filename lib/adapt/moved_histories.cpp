#include "adapt/moved_histories.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "adapt/field_at.hpp"
#include "adapt/point_shares.hpp"
#include "base/all_to_all.hpp"
#include "fem/cell_info.hpp"
#include "state/moved.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Returns what tells columns from others of their cells or sides. A cell has one material; a side may have several
/// interactions.
std::string kind_of(const std::string& term, bool on_sides, const PointColumns& columns) {
  std::string kind = on_sides ? term : "";
  for (const Column& column : columns.columns) kind += '\n' + column.name;
  return kind;
}

std::array<double, 3> mean(const std::array<double, 3>& a, const std::array<double, 3>& b, double share) {
  std::array<double, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = (1 - share) * a[i] + share * b[i];
  return result;
}

/// The cells and sides of a mesh, and the points on them, in the trees.
class Places {
 public:
  explicit Places(const SplitMesh& mesh) : mesh_(mesh) {}

  /// Returns the point of a cell or a side at reference coordinates, see PointColumns.
  RootPoint point(const PointOwner& owner, const std::array<double, 3>& place) const {
    const SplitMesh::Cell cell{owner.block, owner.cell};
    return mesh_.root_point(cell, owner.side < 0 ? place : on_side(owner, place));
  }
  int leaf(const PointOwner& owner) const {
    if (owner.part != 0) throw std::logic_error("parts of sides do not move to other meshes");
    return mesh_.leaf_of({owner.block, owner.cell});
  }
  /// Returns SplitMesh::face_of(); -1 for a cell.
  int face(const PointOwner& owner) const {
    return owner.side < 0 ? -1 : mesh_.face_of({owner.block, owner.cell}, owner.side);
  }

 private:
  std::array<double, 3> on_side(const PointOwner& owner, const std::array<double, 3>& place) const {
    const CellType type = mesh_.mesh().blocks[at(owner.block)].type;
    const auto corners = side_nodes(corner_type(type), owner.side);
    const auto corner = [&](std::size_t k) { return *reference_place(type, at(corners[k])); };
    if (corners.size() == 3) {
      const RootPlace origin = corner(0), first = corner(1), second = corner(2);
      RootPlace result{};
      for (std::size_t i = 0; i < 3; ++i)
        result[i] = origin[i] + place[0] * (first[i] - origin[i]) + place[1] * (second[i] - origin[i]);
      return result;
    }
    const double s = (1 + place[0]) / 2, t = (1 + place[1]) / 2;
    if (mesh_.mesh().dimension == 2) return mean(corner(0), corner(1), s);
    return mean(mean(corner(0), corner(1), s), mean(corner(3), corner(2), s), t);
  }

  const SplitMesh& mesh_;
};

/// Returns the columns of a term with the numbers of all ranks; a cell that several have may come twice. Collective.
PointColumns gathered(const PointColumns& own, const Comm& comm) {
  const PointData& data = own.values;
  const std::size_t size = data.points() * data.numbers();
  std::vector<double> mine;
  const std::vector<double> values = data.cell_by_cell();
  for (std::size_t cell = 0; cell < data.owners().size(); ++cell) {
    const PointOwner& owner = data.owners()[cell];
    for (const int number : {owner.block, owner.cell, owner.side, owner.part}) mine.push_back(number);
    mine.insert(mine.end(), values.begin() + static_cast<std::ptrdiff_t>(cell * size),
                values.begin() + static_cast<std::ptrdiff_t>((cell + 1) * size));
  }
  constexpr std::size_t head = 4;
  std::vector<PointOwner> owners;
  std::vector<const double*> rows;
  const std::vector<double> all = of_all_ranks(mine, comm);
  for (std::size_t i = 0; i < all.size(); i += head + size) {
    const auto number = [&](std::size_t k) { return static_cast<int>(all[i + k]); };
    owners.push_back({number(0), number(1), number(2), number(3)});
    rows.push_back(&all[i + head]);
  }
  PointColumns result{own.columns, PointData(owners, data.points(), data.numbers()), own.places};
  for (std::size_t cell = 0; cell < rows.size(); ++cell) result.values.set_cell(cell, rows[cell]);
  return result;
}

/// The numbers of one kind before, by leaf and face.
class Past {
 public:
  explicit Past(const SplitMesh& mesh) : mesh_(mesh), places_(mesh) {}

  void add(PointColumns columns) {
    const std::vector<PointOwner>& owners = columns.values.owners();
    for (std::size_t cell = 0; cell < owners.size(); ++cell)
      found_[{places_.leaf(owners[cell]), places_.face(owners[cell])}] = {all_.size(), cell};
    all_.push_back(std::move(columns));
  }

  /// Moves them to the points of cells or sides of another mesh. `surface`: of friction; null for others.
  void move_to(const SplitMesh& mesh, const SlidingSurface* surface, PointColumns& to) const {
    const Places places(mesh);
    std::vector<std::vector<PointSource>> sources(all_.size());
    std::vector<std::pair<std::size_t, std::size_t>> free;  // rows and points where nothing resists slip
    const std::vector<PointOwner>& owners = to.values.owners();
    for (std::size_t row = 0; row < owners.size(); ++row) {
      const int face = places.face(owners[row]);
      for (std::size_t q = 0; q < to.places.size(); ++q) {
        const RootPoint point = places.point(owners[row], to.places[q]);
        const std::vector<Found> around = rows_around(point, face);
        if (around.empty()) continue;
        PointSource source{row, q, {}, {}};
        for (const Found& found : around)
          for (const auto& [number, weight] : shares_of(found, face, point))
            source.shares.push_back({found.second, number, weight / static_cast<double>(around.size())});
        if (surface != nullptr) {
          source.normal = normal_at(mesh, *surface, point);
          double gap = 0;
          evaluate(mesh, surface->gap, 1, point, &gap);
          if (!(gap < surface->cutoff)) free.emplace_back(row, q);
        }
        sources[around.front().first].push_back(std::move(source));
      }
    }
    for (std::size_t term = 0; term < all_.size(); ++term) move_columns(all_[term], sources[term], to);
    for (const auto& [row, q] : free) clear_slip(row, q, to);
  }

 private:
  using Found = std::pair<std::size_t, std::size_t>;  ///< a term, and a row there

  /// Returns the rows of one term at a point, several if it lies between cells.
  std::vector<Found> rows_around(const RootPoint& point, int face) const {
    std::vector<Found> rows;
    for (const int leaf : mesh_.tree().leaves_at(point, same_place)) {
      const auto found = found_.find({leaf, face});
      if (found == found_.end() || std::find(rows.begin(), rows.end(), found->second) != rows.end()) continue;
      if (rows.empty() || rows.front().first == found->second.first) rows.push_back(found->second);
    }
    return rows;
  }
  std::vector<ShareOfPoint> shares_of(const Found& found, int face, const RootPoint& point) const {
    std::vector<RootPlace>& points = points_[found];
    if (points.empty())
      for (const auto& place : all_[found.first].places)
        points.push_back(places_.point(all_[found.first].values.owners()[found.second], place).at);
    const SplitTree& tree = mesh_.tree();
    return tree.cell(tree.root(point.block, point.root)).shape == TreeShape::Box
               ? shares_in_grid(points, point.at)
               : shares_in_simplex(points, tree.dimension(), tree.dimension() - (face < 0 ? 0 : 1), point.at);
  }
  static std::array<double, 3> normal_at(const SplitMesh& mesh, const SlidingSurface& surface, const RootPoint& point) {
    std::array<double, 3> normal{};
    evaluate(mesh, surface.normal, at(mesh.mesh().dimension), point, normal.data());
    const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    for (double& component : normal) component = length > 0 ? component / length : 0;
    return normal;
  }
  static void clear_slip(std::size_t row, std::size_t q, PointColumns& columns) {
    std::size_t first = 0;
    for (const Column& column : columns.columns) {
      if (column.kind == ColumnKind::SurfaceVector || column.kind == ColumnKind::Scalar)
        for (std::size_t i = 0; i < column.count; ++i)
          columns.values(row / pack_width, q, first + i)[row % pack_width] = 0;
      first += column.count;
    }
  }

  const SplitMesh& mesh_;
  const Places places_;
  std::vector<PointColumns> all_;               ///< by term
  std::map<std::pair<int, int>, Found> found_;  ///< by leaf and face
  mutable std::map<Found, std::vector<RootPlace>> points_;
};

/// Calls visit(term's name, kind, columns) for all that a model's points keep.
template <class Histories, class Visit>
void for_each_kind(const Model& model, Histories& histories, const Visit& visit) {
  const std::vector<std::string> names = model.slot_names();
  for (std::size_t slot = 0; slot < histories.size(); ++slot)
    for (auto& columns : histories.of(slot).points) {
      const std::vector<PointOwner>& owners = columns.values.owners();
      const bool on_sides = model.space().maximum(!owners.empty() && owners.front().side >= 0 ? 1 : 0) > 0;
      visit(names[slot], kind_of(names[slot], on_sides, columns), columns);
    }
}

}  // namespace

bool keeps_something(const TermHistories& histories) {
  for (std::size_t slot = 0; slot < histories.size(); ++slot)
    if (!histories.of(slot).points.empty()) return true;
  return false;
}

void move_histories(const SplitMesh& from, const Model& before, const TermHistories& past, const SplitMesh& to,
                    const Model& after, const SlidingSurfaces& surfaces, TermHistories& histories) {
  std::map<std::string, Past> known;
  for_each_kind(before, past, [&](const std::string&, const std::string& kind, const PointColumns& columns) {
    known.emplace(kind, from).first->second.add(gathered(columns, before.space().comm()));
  });
  for_each_kind(after, histories, [&](const std::string& name, const std::string& kind, PointColumns& columns) {
    const auto surface = surfaces.find(name);
    if (const auto found = known.find(kind); found != known.end())
      found->second.move_to(to, surface == surfaces.end() ? nullptr : &surface->second, columns);
  });
}

}  // namespace ixos
