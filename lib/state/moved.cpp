#include "state/moved.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ixos {
namespace {

/// Places of the independent components of a column, see Components::symmetric: of a plane and its normal, or all.
std::vector<std::array<std::size_t, 2>> components(std::size_t count) {
  if (count == 4) return {{0, 0}, {0, 1}, {1, 1}, {2, 2}};
  if (count == 6) return {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
  throw std::logic_error("a unimodular tensor has 4 or 6 numbers");
}

using Matrix = std::array<double, 9>;

/// Adds factor * change(eigenvalue) on the eigenvectors of a symmetric matrix to `sum`.
template <class Change>
void add_function(Matrix matrix, double factor, const Change& change, Matrix& sum) {
  std::array<double, 3> values{};
  std::array<double, 64> work{};
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', 3, matrix.data(), 3, values.data(), work.data(),
                                      static_cast<int>(work.size()), &info);
  if (info != 0) throw std::logic_error("a unimodular tensor has no eigenvalues");
  for (std::size_t n = 0; n < 3; ++n)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        sum[3 * j + i] += factor * change(values[n]) * matrix[3 * n + i] * matrix[3 * n + j];
}

double number(const PointData& data, std::size_t cell, std::size_t point, std::size_t place) {
  return double(data(cell / pack_width, point, place)[cell % pack_width]);
}

class ColumnMove {
 public:
  ColumnMove(const Column& column, std::size_t first, const PointData& from)
      : column_(column), first_(first), from_(from) {}

  std::vector<double> at(const PointSource& source) const {
    if (column_.kind == ColumnKind::UnimodularTensor && source.shares.size() > 1) return tensor(source.shares);
    std::vector<double> result(column_.count);
    if (column_.kind == ColumnKind::Nearest) {
      const PointShare& nearest =
          *std::max_element(source.shares.begin(), source.shares.end(),
                            [](const PointShare& a, const PointShare& b) { return a.weight < b.weight; });
      for (std::size_t i = 0; i < result.size(); ++i) result[i] = value(nearest, i);
    } else if (source.shares.size() == 1) {
      for (std::size_t i = 0; i < result.size(); ++i) result[i] = value(source.shares[0], i);
    } else {
      for (const PointShare& share : source.shares)
        for (std::size_t i = 0; i < result.size(); ++i) result[i] += share.weight * value(share, i);
    }
    if (column_.kind == ColumnKind::SurfaceVector) {
      double along = 0;
      for (std::size_t i = 0; i < result.size(); ++i) along += source.normal[i] * result[i];
      for (std::size_t i = 0; i < result.size(); ++i) result[i] -= along * source.normal[i];
    }
    return result;
  }

 private:
  double value(const PointShare& share, std::size_t i) const {
    return number(from_, share.cell, share.point, first_ + i);
  }

  std::vector<double> tensor(const std::vector<PointShare>& shares) const {
    const auto places = components(column_.count);
    Matrix logarithm{};
    for (const PointShare& share : shares) {
      Matrix strain{};
      for (std::size_t k = 0; k < places.size(); ++k) {
        const auto [i, j] = places[k];
        strain[3 * i + j] = strain[3 * j + i] = value(share, k);
      }
      // C - I, so that nothing of a small strain is lost.
      add_function(
          strain, share.weight, [](double x) { return std::log1p(x); }, logarithm);
    }
    Matrix mean{};
    add_function(
        logarithm, 1, [](double x) { return std::expm1(x); }, mean);
    std::vector<double> result;
    result.reserve(places.size());
    for (const auto& [i, j] : places) result.push_back(mean[3 * i + j]);
    return result;
  }

  const Column& column_;
  std::size_t first_;
  const PointData& from_;
};

void check(const PointSource& source) {
  double sum = 0;
  for (const PointShare& share : source.shares) {
    if (!(share.weight >= 0)) throw std::logic_error("a share of a point is negative");
    sum += share.weight;
  }
  if (!(std::abs(sum - 1) < 1e-12)) throw std::logic_error("the shares of a point do not sum to 1");
}

std::vector<double> moved(const std::vector<double>& field, const StateSource& source) {
  if (field.empty()) return {};
  std::vector<double> result(source.nodes.size() * source.dimension);
  for (std::size_t node = 0; node < source.nodes.size(); ++node)
    for (const NodeShare& share : source.nodes[node])
      for (std::size_t d = 0; d < source.dimension; ++d)
        result[node * source.dimension + d] += share.weight * field[share.node * source.dimension + d];
  return result;
}

}  // namespace

void move_columns(const PointColumns& from, const std::vector<PointSource>& sources, PointColumns& to) {
  const bool same = std::equal(
      from.columns.begin(), from.columns.end(), to.columns.begin(), to.columns.end(),
      [](const Column& a, const Column& b) { return a.name == b.name && a.kind == b.kind && a.count == b.count; });
  if (!same) throw std::logic_error("the columns of two histories differ");
  for (const PointSource& source : sources) check(source);
  std::size_t first = 0;
  for (const Column& column : from.columns) {
    const ColumnMove move(column, first, from.values);
    for (const PointSource& source : sources) {
      const std::vector<double> values = move.at(source);
      for (std::size_t i = 0; i < values.size(); ++i)
        to.values(source.cell / pack_width, source.point, first + i)[source.cell % pack_width] = values[i];
    }
    first += column.count;
  }
}

State moved(const State& state, const StateSource& source, TermHistories histories) {
  State result;
  result.u = moved(state.u, source);
  result.v = moved(state.v, source);
  result.a = moved(state.a, source);
  result.time = state.time;
  const std::size_t slots = std::min({source.points.size(), state.histories.size(), histories.size()});
  for (std::size_t slot = 0; slot < slots; ++slot) {
    if (source.points[slot].empty()) continue;
    const std::vector<PointColumns>& from = state.histories.of(slot).points;
    std::vector<PointColumns>& to = histories.of(slot).points;
    for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k)
      move_columns(from[k], source.points[slot], to[k]);
  }
  result.histories = std::move(histories);
  return result;
}

}  // namespace ixos
