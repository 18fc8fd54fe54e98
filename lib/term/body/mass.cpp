#include "term/body/mass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>

#include "base/error.hpp"
#include "base/small_matrix.hpp"
#include "fem/cell_info.hpp"
#include "fem/jacobian.hpp"
#include "fem/revolved.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

/// Returns the factor of an element matrix's diagonal in the lumped mass: the mass over the diagonal's sum.
template <std::size_t N>
double diagonal_scale(const Small<double, N>& element) {
  double mass = 0, diagonal = 0;
  for (std::size_t a = 0; a < N; ++a) {
    diagonal += element[a][a];
    for (std::size_t b = 0; b < N; ++b) mass += element[a][b];
  }
  return mass / diagonal;
}

/// Whether an element lists nodal_weights(): those of its lumped mass.
template <class Element, class = void>
struct HasNodalWeights : std::false_type {};
template <class Element>
struct HasNodalWeights<Element, std::void_t<decltype(Element::nodal_weights())>> : std::true_type {};

/// Adds the masses of quadrature at the nodes: the weights are those of the row sums of straight cells. The Jacobian of
/// curved triangles and tetrahedra is of degree 3 at most, so that their total is exact; prisms are scaled to theirs.
template <class Element>
void add_at_nodes(const LocalMesh& mesh, const LocalBlock& block, double density, const Pattern& pattern,
                  std::vector<double>& masses) {
  constexpr std::size_t D = Element::dimension, N = Element::nodes;
  const auto weights = Element::nodal_weights();
  [[maybe_unused]] const auto rule = own_rule<Element>();
  for (int cell = 0; cell < block.cells(); ++cell) {
    const int* nodes = &block.nodes[cell_entry(cell, N)];
    std::array<double, N> at_nodes;
    [[maybe_unused]] double sum = 0, exact = 0;
    for (std::size_t a = 0; a < N; ++a) {
      at_nodes[a] =
          density * weights[a] * determinant(jacobian_at<Element, D>(Element::place(a), mesh.coordinates, nodes));
      sum += at_nodes[a];
    }
    if constexpr (CellTraits<Element>::shape == ReferenceShape::Prism) {
      for (std::size_t q = 0; q < rule.size(); ++q)
        exact +=
            density * rule.weights[q] * determinant(jacobian_at<Element, D>(rule.points[q], mesh.coordinates, nodes));
      for (double& mass : at_nodes) mass *= exact / sum;
    }
    for (std::size_t a = 0; a < N; ++a) {
      const double mass = at_nodes[a];
      pattern.ties().for_each_share(nodes[a], [&](int row, double weight) {
        if (row < pattern.rows()) masses[static_cast<std::size_t>(row)] += weight * mass;
      });
    }
  }
}

template <class Element>
void add(const LocalMesh& mesh, const LocalBlock& block, double density, const Pattern& pattern, bool lumped,
         std::vector<double>& pairs) {
  constexpr std::size_t D = Element::dimension;
  constexpr std::size_t N = Element::nodes;
  if constexpr (HasNodalWeights<Element>::value)
    if (lumped && !mesh.axisymmetric) return add_at_nodes<Element>(mesh, block, density, pattern, pairs);
  const ShapeTable<Element> table(mass_rule<Element>(), block.tied);
  for (int cell = 0; cell < block.cells(); ++cell) {
    const int* nodes = &block.nodes[cell_entry(cell, N)];
    const auto scale = cell_scales<Element>(block, cell);
    Small<double, N> element{};
    for (std::size_t q = 0; q < table.size(); ++q) {
      double weight =
          density * table.weight[q] * determinant(jacobian<D>(mesh.coordinates, nodes, scale, table.gradient[q]));
      if (mesh.axisymmetric) weight *= circumference(mesh.coordinates, nodes, scale, table.value[q]);
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t b = 0; b < N; ++b)
          element[a][b] += weight * scale[a] * table.value[q][a] * scale[b] * table.value[q][b];
    }
    // Row sums of quadratic cells need not be positive; those of the pyramid with bubbles are.
    const bool scaled = lumped && is_quadratic(block.type) && block.type != CellType::Pyr19;
    const double scale_of_diagonal = scaled ? diagonal_scale(element) : 1;
    for (std::size_t a = 0; a < N; ++a)
      pattern.ties().for_each_share(nodes[a], [&](int row, double weight) {
        if (row >= pattern.rows()) return;
        if (scaled) {
          pairs[static_cast<std::size_t>(row)] += weight * scale_of_diagonal * element[a][a];
          return;
        }
        for (std::size_t b = 0; b < N; ++b)
          if (lumped)
            pairs[static_cast<std::size_t>(row)] += weight * element[a][b];
          else
            pattern.ties().for_each_share(nodes[b], [&](int column, double share) {
              pairs[static_cast<std::size_t>(pattern.pair(row, column))] += weight * share * element[a][b];
            });
      });
  }
}

template <std::size_t D>
void multiply_rows(const Pattern& pattern, const std::vector<double>& pairs, const double* x, double* y) {
  const std::vector<int>& start = pattern.row_start();
  const std::vector<int>& column = pattern.columns();
  for (std::size_t row = 0; row + 1 < start.size(); ++row) {
    // Four sums in turn: one would wait for itself.
    std::array<std::array<double, D>, 4> sum{};
    auto p = static_cast<std::size_t>(start[row]);
    const auto end = static_cast<std::size_t>(start[row + 1]);
    const auto add = [&](std::size_t turn) {
      const double* source = x + static_cast<std::size_t>(column[p + turn]) * D;
      for (std::size_t d = 0; d < D; ++d) sum[turn][d] += pairs[p + turn] * source[d];
    };
    for (; p + 4 <= end; p += 4)
      for (std::size_t turn = 0; turn < 4; ++turn) add(turn);
    for (; p < end; ++p) add(0);
    for (std::size_t d = 0; d < D; ++d) y[row * D + d] = (sum[0][d] + sum[1][d]) + (sum[2][d] + sum[3][d]);
  }
}

}  // namespace

Mass::Mass(const LocalMesh& mesh, const Pattern& pattern, bool lumped)
    : mesh_(mesh),
      pattern_(pattern),
      lumped_(lumped),
      pairs_(static_cast<std::size_t>(lumped ? pattern.rows() : pattern.pairs()), 0.0) {}

void Mass::add_block(const LocalBlock& block, double density) {
  if (lumped_ && is_hermite(block.type))
    throw InputError("block \"" + block.name +
                     "\": a Hermite contact element (Q1CH) has no lumped mass, which explicit schemes need");
  const CellInfo& info = cell_info(block.type);
  if (lumped_ && info.order == 2 && !is_cube(block.type) && !info.bubbles)
    throw InputError(fmt::format(
        "block \"{}\": {} cells have no lumped mass as accurate as their displacements, which explicit schemes need; "
        "raise_order() with bubbles makes {} cells of them",
        block.name, info.name, cell_info(raised_type(block.type, true)).name));
  bodies_.push_back({&block, density});
  integrate(block, density);
}

void Mass::check_lumped() const {
  if (!lumped_ || pattern_.ties().empty()) return;
  for (int node = 0; node < pattern_.rows(); ++node)
    if (!(pairs_[static_cast<std::size_t>(node)] > 0))
      throw InputError(fmt::format(
          "node {} has no positive lumped mass, because of the nodes that are tied to it with negative weights; use a "
          "scheme with a consistent mass",
          mesh_.message_number(static_cast<std::size_t>(node))));
}

void Mass::place() {
  pairs_.assign(static_cast<std::size_t>(lumped_ ? pattern_.rows() : pattern_.pairs()), 0.0);
  for (const Body& body : bodies_) integrate(*body.block, body.density);
}

void Mass::integrate(const LocalBlock& block, double density) {
  with_element(block.type, [&](auto element) {
    add<typename decltype(element)::type>(mesh_, block, density, pattern_, lumped_, pairs_);
  });
}

void Mass::divide(const double* y, double* x) const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  for (std::size_t i = 0; i < pairs_.size() * d; ++i) x[i] = y[i] / pairs_[i / d];
}

double Mass::largest_quotient(const double* y) const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  double largest = 0;
  for (std::size_t i = 0; i < pairs_.size() * d; ++i) largest = std::max(largest, y[i] / pairs_[i / d]);
  return largest;
}

void Mass::multiply(const double* x, double* y) const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  if (lumped_)
    for (std::size_t i = 0; i < pairs_.size() * d; ++i) y[i] = pairs_[i / d] * x[i];
  else if (mesh_.dimension == 2)
    multiply_rows<2>(pattern_, pairs_, x, y);
  else
    multiply_rows<3>(pattern_, pairs_, x, y);
}

void Mass::add_to(double factor, double* values) const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  const std::vector<int>& start = pattern_.row_start();
  for (std::size_t row = 0; row + 1 < start.size(); ++row) {
    const auto first = static_cast<std::size_t>(start[row]);
    const std::size_t length = static_cast<std::size_t>(start[row + 1]) - first;
    double* block = values + d * d * first;
    if (lumped_) {
      const auto node = static_cast<int>(row);
      for (int i = 0; i < mesh_.dimension; ++i)
        values[pattern_.offset(node, node) + pattern_.stride(node) * i + i] += factor * pairs_[row];
      continue;
    }
    for (std::size_t p = 0; p < length; ++p) {
      const double m = factor * pairs_[first + p];
      for (std::size_t i = 0; i < d; ++i) block[d * length * i + d * p + i] += m;
    }
  }
}

namespace {

template <std::size_t D>
void set_rows(const Pattern& pattern, const std::vector<double>& pairs, double factor, double* values) {
  const std::vector<int>& start = pattern.row_start();
  for (std::size_t row = 0; row + 1 < start.size(); ++row) {
    const auto first = static_cast<std::size_t>(start[row]);
    const std::size_t length = static_cast<std::size_t>(start[row + 1]) - first;
    for (std::size_t p = 0; p < length; ++p) {
      const double m = factor * pairs[first + p];
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) values[D * (length * i + p) + j] = i == j ? m : 0.0;
    }
    values += D * D * length;
  }
}

}  // namespace

void Mass::set(double factor, double* values) const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  if (lumped_) {
    std::fill_n(values, pattern_.matrix_values(), 0.0);
    add_to(factor, values);
  } else if (d == 2) {
    set_rows<2>(pattern_, pairs_, factor, values);
  } else {
    set_rows<3>(pattern_, pairs_, factor, values);
  }
}

void Mass::add_diagonal(double factor, double* d) const {
  const auto dimension = static_cast<std::size_t>(mesh_.dimension);
  for (int row = 0; row < pattern_.rows(); ++row) {
    const double m = pairs_[static_cast<std::size_t>(lumped_ ? row : pattern_.pair(row, row))];
    for (std::size_t i = 0; i < dimension; ++i) d[static_cast<std::size_t>(row) * dimension + i] += factor * m;
  }
}

}  // namespace ixos
