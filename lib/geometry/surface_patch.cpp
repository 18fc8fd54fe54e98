#include "geometry/surface_patch.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/vector3.hpp"
#include "geometry/bernstein.hpp"

namespace ixos {
namespace {

constexpr std::size_t most_powers = 5;
/// Powers of one parameter, or their derivatives.
using Powers = std::array<double, most_powers>;

/// By order of the derivative, 0 to 2: the derivatives of t^0 ... t^degree.
std::array<Powers, 3> powers_of(double t, int degree) {
  std::array<Powers, 3> result{};
  double power = 1;
  for (int k = 0; k <= degree; ++k) {
    const auto place = static_cast<std::size_t>(k);
    result[0][place] = power;
    if (k > 0) result[1][place] = k * result[0][place - 1];
    if (k > 1) result[2][place] = k * (k - 1) * result[0][place - 2];
    power *= t;
  }
  return result;
}

/// The tensor powers of all parameters, or their derivatives.
template <std::size_t D>
using Tensor = std::array<double, PlacedPatch<D>::most>;

template <std::size_t D>
struct Tensors {
  Tensor<D> value{};
  std::array<Tensor<D>, D - 1> first{};
  std::size_t size = 0;

  Tensors(const PatchParameters<D>& xi, int degree) {
    const auto n = static_cast<std::size_t>(degree) + 1;
    const std::array<Powers, 3> a = powers_of(xi[0], degree);
    if constexpr (D == 2) {
      size = n;
      for (std::size_t i = 0; i < n; ++i) {
        value[i] = a[0][i];
        first[0][i] = a[1][i];
      }
    } else {
      const std::array<Powers, 3> b = powers_of(xi[1], degree);
      size = n * n;
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
          value[n * j + i] = a[0][i] * b[0][j];
          first[0][n * j + i] = a[1][i] * b[0][j];
          first[1][n * j + i] = a[0][i] * b[1][j];
        }
    }
  }
};

/// Sums over the powers of a patch of N powers in each parameter, with constant bounds.
template <std::size_t N>
struct Polynomial {
  static constexpr std::size_t size = N;
  using Line = std::array<double, N>;
  /// The powers of one parameter and their first two derivatives.
  using Lines = std::array<Line, 3>;
  using Coefficients2 = std::array<Vec<2>, PlacedPatch<2>::most>;
  using Coefficients3 = std::array<Vec<3>, PlacedPatch<3>::most>;

  static Line powers(double t) {
    Line line;
    line[0] = 1;
    for (std::size_t k = 1; k < N; ++k) line[k] = t * line[k - 1];
    return line;
  }
  static Lines with_derivatives(double t) {
    Lines lines{powers(t)};
    for (std::size_t k = 1; k < N; ++k) {
      lines[1][k] = static_cast<double>(k) * lines[0][k - 1];
      lines[2][k] = static_cast<double>(k) * lines[1][k - 1];
    }
    return lines;
  }
  static Vec<2> sum(const Line& a, const Coefficients2& c) {
    Vec<2> result{};
    for (std::size_t k = 0; k < N; ++k)
      for (std::size_t i = 0; i < 2; ++i) result[i] += a[k] * c[k][i];
    return result;
  }
  /// The components of all powers of the first parameter, one after the other.
  using Row = std::array<double, 3 * N>;
  static std::array<Row, N> rows(const Coefficients3& c) {
    std::array<Row, N> result;
    static_assert(sizeof result == N * N * sizeof(Vec<3>));
    std::memcpy(result.data(), c.data(), sizeof result);
    return result;
  }
  /// Returns the sums along the second parameter, by power of the first.
  static Row across(const Line& b, const std::array<Row, N>& c) {
    Row result{};
    for (std::size_t j = 0; j < N; ++j)
      for (std::size_t k = 0; k < 3 * N; ++k) result[k] += b[j] * c[j][k];
    return result;
  }
  static Vec<3> sum(const Line& a, const Row& c) {
    Vec<3> result{};
    for (std::size_t k = 0; k < N; ++k)
      for (std::size_t i = 0; i < 3; ++i) result[i] += a[k] * c[3 * k + i];
    return result;
  }
  static Vec<2> at(const PlacedPatch<2>& patch, const PatchParameters<2>& xi) {
    return sum(powers(xi[0]), patch.coefficients);
  }
  static Vec<3> at(const PlacedPatch<3>& patch, const PatchParameters<3>& xi) {
    return sum(powers(xi[0]), across(powers(xi[1]), rows(patch.coefficients)));
  }
  static PlacedPatch<2>::Frame frame(const PlacedPatch<2>& patch, const PatchParameters<2>& xi) {
    const Lines a = with_derivatives(xi[0]);
    const Coefficients2& c = patch.coefficients;
    return {sum(a[0], c), {sum(a[1], c)}, {sum(a[2], c)}};
  }
  static PlacedPatch<3>::Frame frame(const PlacedPatch<3>& patch, const PatchParameters<3>& xi) {
    const Lines a = with_derivatives(xi[0]), b = with_derivatives(xi[1]);
    const auto c = rows(patch.coefficients);
    const Row c0 = across(b[0], c), c1 = across(b[1], c), c2 = across(b[2], c);
    return {sum(a[0], c0), {sum(a[1], c0), sum(a[0], c1)}, {sum(a[2], c0), sum(a[1], c1), sum(a[0], c2)}};
  }
};

/// Calls visit with the Polynomial of a degree.
template <class Visit>
auto with_degree(int degree, const Visit& visit) {
  switch (degree) {
    case 1:
      return visit(Polynomial<2>());
    case 2:
      return visit(Polynomial<3>());
    case 3:
      return visit(Polynomial<4>());
    default:
      return visit(Polynomial<5>());
  }
}

/// weights += factor * x, for `count` nodes.
template <class Weights>
void add_scaled(double factor, const double* x, std::size_t count, Weights& weights) {
  for (std::size_t a = 0; a < count; ++a) weights[a] += factor * x[a];
}

/// Converts the coefficients of D - 1 parameters in place, from powers to Bernstein polynomials.
template <std::size_t D, class T>
void to_bernstein(int degree, T* points) {
  with_degree(degree, [&](auto polynomial) {
    constexpr std::size_t n = decltype(polynomial)::size;
    static constexpr auto share = bernstein_shares<n - 1>();
    const auto convert = [&](T* first, std::size_t stride) {
      for (std::size_t i = n; i-- > 0;) {  // the later ones need the earlier ones' coefficients
        T sum = share[i][0] * first[0];
        for (std::size_t k = 1; k <= i; ++k) sum = sum + share[i][k] * first[stride * k];
        first[stride * i] = sum;
      }
    };
    if constexpr (D == 2) {
      convert(points, 1);
    } else {
      for (std::size_t i = 0; i < n; ++i) convert(points + n * i, 1);
      for (std::size_t i = 0; i < n; ++i) convert(points + i, n);
    }
  });
}

}  // namespace

template <std::size_t D>
Vec<D> PlacedPatch<D>::at(const PatchParameters<D>& xi) const {
  return with_degree(degree, [&](auto polynomial) { return decltype(polynomial)::at(*this, xi); });
}

template <std::size_t D>
typename PlacedPatch<D>::Frame PlacedPatch<D>::frame(const PatchParameters<D>& xi) const {
  return with_degree(degree, [&](auto polynomial) { return decltype(polynomial)::frame(*this, xi); });
}

template <std::size_t D>
Vec<D> PlacedPatch<D>::normal(const Frame& frame) {
  Vec<D> n;
  const Vec<D>& a = frame.tangents[0];
  if constexpr (D == 2) {
    n = {a[1], -a[0]};
  } else {
    n = cross(a, frame.tangents[1]);
  }
  return (1 / std::sqrt(inner(n, n))) * n;
}

template <std::size_t D>
boost::container::static_vector<Vec<D>, PlacedPatch<D>::most> PlacedPatch<D>::hull() const {
  const auto n = static_cast<std::size_t>(degree) + 1;
  std::array<Vec<D>, most> points = coefficients;
  to_bernstein<D>(degree, points.data());
  return {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(D == 2 ? n : n * n)};
}

template <std::size_t D>
void SurfacePatch<D>::set_functions(const std::vector<double>& by_node) {
  coefficients.resize(by_node.size());
  const std::size_t size = powers();
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t k = 0; k < size; ++k) coefficients[k * count + a] = by_node[a * size + k];
}

template <std::size_t D>
typename SurfacePatch<D>::Weights SurfacePatch<D>::weights(const PatchParameters<D>& xi) const {
  const Tensors<D> tensors(xi, degree);
  Weights n{};
  for (std::size_t k = 0; k < tensors.size; ++k) add_scaled(tensors.value[k], &coefficients[k * count], count, n);
  return n;
}

template <std::size_t D>
typename SurfacePatch<D>::Shape SurfacePatch<D>::shape(const PatchParameters<D>& xi) const {
  const Tensors<D> tensors(xi, degree);
  Shape result;
  const auto set = [&](Weights& weights, const Tensor<D>& tensor) {
    for (std::size_t k = 0; k < tensors.size; ++k) add_scaled(tensor[k], &coefficients[k * count], count, weights);
  };
  set(result.value, tensors.value);
  for (std::size_t k = 0; k < tensors.first.size(); ++k) set(result.slopes[k], tensors.first[k]);
  return result;
}

template <std::size_t D>
typename SurfacePatch<D>::Points SurfacePatch<D>::among(const std::vector<Vec<D>>& x) const {
  Points result{};
  for (std::size_t a = 0; a < count; ++a) result[a] = x[static_cast<std::size_t>(nodes[a])];
  return result;
}

template <std::size_t D>
PlacedPatch<D> SurfacePatch<D>::placed(const Points& x) const {
  PlacedPatch<D> result;
  result.degree = degree;
  const std::size_t size = powers();
  for (std::size_t k = 0; k < size; ++k)
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t i = 0; i < D; ++i) result.coefficients[k][i] += coefficients[k * count + a] * x[a][i];
  return result;
}

template <std::size_t D>
double SurfacePatch<D>::amplification() const {
  std::vector<double> sums(powers(), 0.0);
  for (std::size_t a = 0; a < count; ++a) {
    std::vector<double> weights;
    for (std::size_t k = 0; k < sums.size(); ++k) weights.push_back(coefficients[k * count + a]);
    to_bernstein<D>(degree, weights.data());
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += std::abs(weights[k]);
  }
  return *std::max_element(sums.begin(), sums.end());
}

template struct PlacedPatch<2>;
template struct PlacedPatch<3>;
template struct SurfacePatch<2>;
template struct SurfacePatch<3>;

}  // namespace ixos
