#include "fem/cell_info.hpp"

#include <stdexcept>
#include <type_traits>

#include "fem/corner_element.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

/// Returns the type of an element type.
template <class Element>
constexpr CellType type_of() {
#define IXOS_CELL(Other) \
  if constexpr (std::is_same_v<Element, Other>) return CellType::Other;
#include "fem/cells.def"
}

template <class Element>
std::vector<NodeCorners> node_corners_of() {
  if constexpr (!std::is_same_v<typename CellTraits<Element>::Plain, Element>) {
    return {};
  } else if constexpr (HasRule<Element>::value) {
    return Element::node_corners();
  } else if constexpr (!std::is_void_v<typename CornerElement<Element>::type>) {
    return corners_of_nodes<Element>();
  } else {
    std::vector<NodeCorners> result;
    result.reserve(Element::nodes);
    for (int a = 0; a < Element::nodes; ++a) result.push_back({a});
    return result;
  }
}

template <class Element>
CellInfo info_of(std::string_view name) {
  using Traits = CellTraits<Element>;
  return {type_of<Element>(),
          name,
          Traits::shape,
          Element::dimension,
          Element::nodes,
          Traits::order,
          type_of<typename Traits::Corners>(),
          type_of<typename Traits::Plain>(),
          type_of<typename DrawnAs<Element>::type>(),
          Traits::bubbles,
          node_corners_of<Element>(),
          Traits::side_nodes(),
          Traits::contact_side,
          Traits::contact,
          Traits::pieces,
          Traits::hermite,
          Traits::constant_strain,
          Traits::exodus,
          Traits::gmsh};
}

std::vector<CellInfo> make_infos() {
  return {
#define IXOS_CELL(Element) info_of<Element>(#Element),
#include "fem/cells.def"
  };
}

/// Apart from make_infos(), so that a call, of which a mesh makes many, costs nothing of it.
inline const std::vector<CellInfo>& infos() {
  static const std::vector<CellInfo> all = make_infos();
  return all;
}

}  // namespace

const std::vector<CellInfo>& cell_infos() { return infos(); }

const CellInfo& cell_info(CellType type) { return infos().at(static_cast<std::size_t>(type)); }

namespace {

bool is_plain_cube(const CellInfo& info, int dimension) {
  return info.shape == (dimension == 2 ? ReferenceShape::Quadrilateral : ReferenceShape::Hexahedron) &&
         info.plain == info.type;
}

}  // namespace

CellType cube_type(int dimension, int order) {
  const CellInfo* const cube =
      find_cell([&](const CellInfo& info) { return is_plain_cube(info, dimension) && info.order == order; });
  if (cube == nullptr) throw std::logic_error("there are no quadrilaterals and hexahedra of such an order");
  return cube->type;
}

const CellInfo* cell_with(int dimension, int nodes) {
  return find_cell([&](const CellInfo& info) {
    return info.dimension == dimension && info.nodes == nodes && info.plain == info.type;
  });
}

bool is_cube(CellType type) {
  const ReferenceShape shape = cell_info(type).shape;
  return shape == ReferenceShape::Quadrilateral || shape == ReferenceShape::Hexahedron;
}

CellType raised_type(CellType type, bool bubbles) {
  const CellInfo& own = cell_info(type);
  const bool wanted = bubbles && !is_cube(type);
  const CellInfo* const raised = find_cell([&](const CellInfo& info) {
    return info.shape == own.shape && info.order == 2 && info.plain == info.type && info.bubbles == wanted;
  });
  if (raised == nullptr) throw std::logic_error("cells of this shape have no second order");
  return raised->type;
}

int nodes_per_cell(CellType type) { return cell_info(type).nodes; }

int sides_per_cell(CellType type) { return static_cast<int>(cell_info(type).sides.size()); }

CellType corner_type(CellType type) { return cell_info(type).corners; }

CellType plain_type(CellType type) { return cell_info(type).plain; }

bool is_quadratic(CellType type) { return cell_info(type).order == 2; }

bool is_enriched(CellType type) { return plain_type(type) != type; }

int contact_side(CellType type) { return cell_info(type).contact_side; }

bool is_hermite(CellType type) { return cell_info(type).hermite; }

const std::vector<int>& side_nodes(CellType type, int side) {
  return cell_info(type).sides.at(static_cast<std::size_t>(side));
}

}  // namespace ixos
