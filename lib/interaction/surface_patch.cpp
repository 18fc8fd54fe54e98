#include "interaction/surface_patch.hpp"

#include "base/vector3.hpp"

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

/// Sums over the powers of a patch of N powers in each parameter, with constant bounds. `derivatives`: of which order
/// at most.
template <std::size_t N>
struct Polynomial {
  using Line = std::array<double, N>;

  /// Returns t^0 ... t^(N-1), or their derivatives of that order.
  static Line powers(double t, int order) {
    const std::array<Powers, 3> all = powers_of(t, static_cast<int>(N) - 1);
    Line line;
    for (std::size_t k = 0; k < N; ++k) line[k] = all[static_cast<std::size_t>(order)][k];
    return line;
  }
  static Vec<2> sum(const Line& a, const std::array<Vec<2>, PlacedPatch<2>::most>& c) {
    Vec<2> result{};
    for (std::size_t k = 0; k < N; ++k)
      for (std::size_t i = 0; i < 2; ++i) result[i] += a[k] * c[k][i];
    return result;
  }
  /// Returns the sums along the first parameter, by power of the second.
  static std::array<Vec<3>, N> lines(const Line& a, const std::array<Vec<3>, PlacedPatch<3>::most>& c) {
    std::array<Vec<3>, N> result;
    for (std::size_t j = 0; j < N; ++j) {
      result[j] = {};
      for (std::size_t k = 0; k < N; ++k)
        for (std::size_t i = 0; i < 3; ++i) result[j][i] += a[k] * c[N * j + k][i];
    }
    return result;
  }
  static Vec<3> across(const std::array<Vec<3>, N>& lines, const Line& b) {
    Vec<3> result{};
    for (std::size_t j = 0; j < N; ++j)
      for (std::size_t i = 0; i < 3; ++i) result[i] += b[j] * lines[j][i];
    return result;
  }
  static Vec<2> at(const PlacedPatch<2>& patch, const PatchParameters<2>& xi) {
    return sum(powers(xi[0], 0), patch.coefficients);
  }
  static Vec<3> at(const PlacedPatch<3>& patch, const PatchParameters<3>& xi) {
    return across(lines(powers(xi[0], 0), patch.coefficients), powers(xi[1], 0));
  }
  static PlacedPatch<2>::Frame frame(const PlacedPatch<2>& patch, const PatchParameters<2>& xi) {
    return {at(patch, xi), {sum(powers(xi[0], 1), patch.coefficients)}, {sum(powers(xi[0], 2), patch.coefficients)}};
  }
  static PlacedPatch<3>::Frame frame(const PlacedPatch<3>& patch, const PatchParameters<3>& xi) {
    const auto l0 = lines(powers(xi[0], 0), patch.coefficients), l1 = lines(powers(xi[0], 1), patch.coefficients),
               l2 = lines(powers(xi[0], 2), patch.coefficients);
    const Line b0 = powers(xi[1], 0), b1 = powers(xi[1], 1), b2 = powers(xi[1], 2);
    return {across(l0, b0), {across(l1, b0), across(l0, b1)}, {across(l2, b0), across(l1, b1), across(l0, b2)}};
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

double binomial(int n, int k) {
  double result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
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
  return (1 / length(n)) * n;
}

template <std::size_t D>
boost::container::static_vector<Vec<D>, PlacedPatch<D>::most> PlacedPatch<D>::hull() const {
  const auto n = static_cast<std::size_t>(degree) + 1;
  // From powers to Bernstein polynomials: b_i = sum_k C(i, k)/C(p, k) c_k, along each parameter.
  std::array<std::array<double, most_powers>, most_powers> share{};
  for (int i = 0; i <= degree; ++i)
    for (int k = 0; k <= i; ++k)
      share[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = binomial(i, k) / binomial(degree, k);
  std::array<Vec<D>, most> points = coefficients;
  const auto convert = [&](std::size_t first, std::size_t stride) {
    std::array<Vec<D>, most_powers> line{};
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k <= i; ++k) line[i] = line[i] + share[i][k] * points[first + stride * k];
    for (std::size_t i = 0; i < n; ++i) points[first + stride * i] = line[i];
  };
  std::size_t size = n;
  if constexpr (D == 2) {
    convert(0, 1);
  } else {
    size = n * n;
    for (std::size_t i = 0; i < n; ++i) convert(n * i, 1);
    for (std::size_t i = 0; i < n; ++i) convert(i, n);
  }
  return {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(size)};
}

template <std::size_t D>
typename SurfacePatch<D>::Weights SurfacePatch<D>::weights(const PatchParameters<D>& xi) const {
  const Tensors<D> tensors(xi, degree);
  Weights n{};
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t k = 0; k < tensors.size; ++k) n[a] += coefficients[a * tensors.size + k] * tensors.value[k];
  return n;
}

template <std::size_t D>
typename SurfacePatch<D>::Shape SurfacePatch<D>::shape(const PatchParameters<D>& xi) const {
  const Tensors<D> tensors(xi, degree);
  Shape result;
  const auto set = [&](Weights& weights, const Tensor<D>& tensor) {
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t k = 0; k < tensors.size; ++k) weights[a] += coefficients[a * tensors.size + k] * tensor[k];
  };
  set(result.value, tensors.value);
  for (std::size_t k = 0; k < tensors.first.size(); ++k) set(result.slopes[k], tensors.first[k]);
  return result;
}

template <std::size_t D>
PlacedPatch<D> SurfacePatch<D>::placed(const Points& x) const {
  PlacedPatch<D> result;
  result.degree = degree;
  const std::size_t size = powers();
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t k = 0; k < size; ++k)
      for (std::size_t i = 0; i < D; ++i) result.coefficients[k][i] += coefficients[a * size + k] * x[a][i];
  return result;
}

template struct PlacedPatch<2>;
template struct PlacedPatch<3>;
template struct SurfacePatch<2>;
template struct SurfacePatch<3>;

}  // namespace ixos
