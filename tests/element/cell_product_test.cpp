// The tangent without a matrix, of one element: against the kernel's matrix and the mass by quadrature.
#include "element/cell_product.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "element/elastic_kernel.hpp"
#include "element/element_nodes.hpp"
#include "fem/reference_elements.hpp"
#include "material/linear_elastic.hpp"
#include "material/neo_hooke.hpp"

namespace ixos {
namespace {

using test::ElasticKernel;

/// `moduli`: by the moduli of the law, else by its spatial tangent.
template <class ElementType, class MaterialType, class KeptType, int Points = 2, bool moduli = false>
struct Case {
  static constexpr bool has_moduli = moduli;
  using Element = ElementType;
  using Material = MaterialType;
  using Kept = KeptType;
  static constexpr int points = Points;
};

template <class C>
class CellProductTest : public testing::Test {
 protected:
  using Element = typename C::Element;
  using Kept = typename C::Kept;
  using Kernel = ElasticKernel<Element, typename C::Material>;
  using Nodal = typename Kernel::template Nodal<double>;
  using Tangent = typename Kernel::template Tangent<double>;
  static constexpr std::size_t D = Kernel::D;
  static constexpr std::size_t N = Kernel::N;
  static constexpr bool exact = std::is_same_v<Kept, double>;

  static std::array<int, D> points() {
    std::array<int, D> counts{};
    counts.fill(C::points);
    return counts;
  }

  /// A distorted square or cube, a deformation and a change.
  CellProductTest() {
    std::array<double, D> edges;
    edges.fill(1.0);
    x_ = test::ElementNodes<Element>::block(edges);
    const double size = test::ElementNodes<Element>::quadratic ? 0.3 : 1;
    double phase = 0;
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) {
        phase += 1.7;
        x_[a][d] += size * 0.08 * std::sin(phase);
        u_[a][d] = size * 0.05 * std::sin(1.3 * phase);
        change_[a][d] = std::cos(2.1 * phase);
      }
    geometry_ = Kernel::geometry(table_, x_);
  }

  auto product_of(const Rule& rule, double rest, double inertia) const {
    if constexpr (C::has_moduli)
      return ModuliProduct<D>(rule, rest, inertia);
    else
      return SpatialProduct<D>(material_.lame, rule, rest, inertia);
  }
  template <class Product>
  std::vector<Kept> kept(const Product& product, const Nodal& u) const {
    std::vector<Kept> data(table_.size() * product.point_size());
    const typename Kernel::template Segment<double> segment{&zero_, nullptr, &u};
    Kernel::for_each_batch(geometry_, [&](std::size_t first, std::size_t count) {
      const typename Kernel::template Ends<double> ends(geometry_, first, count, segment);
      product.keep(law_in<typename Kernel::Space>(material_), ends.points(), &geometry_.points[first],
                   data.data() + first * product.point_size());
    });
    return data;
  }

  Nodal product(const Rule& rule, double rest, double inertia, const Nodal& u, const Nodal& change) const {
    const auto own = product_of(rule, rest, inertia);
    const std::vector<Kept> data = kept(own, u);
    PointScratch<D, double> scratch(table_.size());
    Nodal f{};
    add_product<Element>(table_, own, data.data(), change, scratch, f);
    return f;
  }

  /// The same by the kernel's matrix and the mass matrix.
  Nodal expected(const Rule& rule, double rest, double inertia) const {
    Tangent k{};
    Kernel::add_tangent(material_, geometry_, {&zero_, nullptr, &u_}, rule, k);
    Rule at_rest = end_rule();
    at_rest.points[0].weight *= rest;
    Kernel::add_tangent(material_, geometry_, {&zero_, nullptr, &zero_}, at_rest, k);
    Nodal f{};
    for (std::size_t r = 0; r < N * D; ++r)
      for (std::size_t c = 0; c < N * D; ++c) f[r / D][r % D] += k[r][c] * change_[c / D][c % D];
    for (std::size_t q = 0; q < table_.size(); ++q)
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t b = 0; b < N; ++b)
          for (std::size_t i = 0; i < D; ++i)
            f[a][i] += inertia * geometry_.points[q].weight * table_.value[q][a] * table_.value[q][b] * change_[b][i];
    return f;
  }

  static double distance(const Nodal& a, const Nodal& b) {
    double square = 0, scale = 0;
    for (std::size_t n = 0; n < N; ++n)
      for (std::size_t d = 0; d < D; ++d) {
        square += (a[n][d] - b[n][d]) * (a[n][d] - b[n][d]);
        scale += b[n][d] * b[n][d];
      }
    return std::sqrt(square / scale);
  }

  typename C::Material material_{lame_constants(1.0, 0.3)};
  ShapeTable<Element> table_{product_rule(points())};
  Nodal x_{}, u_{}, zero_{}, change_{};
  typename Kernel::template Geometry<double> geometry_;
};

using Cases =
    testing::Types<Case<Quad4, NeoHooke, double>, Case<Hex8, NeoHooke, double>, Case<Hex8, NeoHooke, double, 3>,
                   Case<Hex8, LinearElastic, double>, Case<Quad4, NeoHooke, float>, Case<Hex8, NeoHooke, float>,
                   Case<Quad4, NeoHooke, double, 2, true>, Case<Hex8, NeoHooke, double, 2, true>,
                   Case<Hex8, NeoHooke, float, 2, true>, Case<Quad9, NeoHooke, double, 3>,
                   Case<Hex27, NeoHooke, double, 3>, Case<Hex27, NeoHooke, float, 3>,
                   Case<Hex27, LinearElastic, double, 3, true>>;
TYPED_TEST_SUITE(CellProductTest, Cases);

TYPED_TEST(CellProductTest, IsTheMatrixTimesTheChange) {
  // One time point, and two.
  Rule two;
  two.points = {{0.3, 0.4, 0, 0.6}, {0.7, 0, 0, 1}};
  const double tolerance = this->exact ? 2e-15 : 2e-7;
  for (const Rule& rule : {end_rule(), two})
    for (double rest : {0.0, 0.2})
      for (double inertia : {0.0, 0.7})
        EXPECT_LT(this->distance(this->product(rule, rest, inertia, this->u_, this->change_),
                                 this->expected(rule, rest, inertia)),
                  tolerance)
            << rest << ' ' << inertia;
}

TYPED_TEST(CellProductTest, TheDiagonalIsThatOfTheMatrix) {
  const auto own = this->product_of(end_rule(), 0, 0.7);
  const auto data = this->kept(own, this->u_);
  typename TestFixture::Nodal diagonal{};
  add_diagonal<typename TypeParam::Element>(this->table_, own, data.data(), diagonal);
  typename TestFixture::Tangent k{};
  TestFixture::Kernel::add_tangent(this->material_, this->geometry_, {&this->zero_, nullptr, &this->u_}, end_rule(), k);
  for (std::size_t r = 0; r < this->N * this->D; ++r)
    EXPECT_NEAR(diagonal[r / this->D][r % this->D], k[r][r], (this->exact ? 2e-15 : 3e-7) * k[r][r]);
}

// What single precision must not cost: slender bodies rotate far where they strain little.
TYPED_TEST(CellProductTest, ARotationOfTheUndeformedBodyIsFree) {
  typename TestFixture::Nodal rotation{};
  for (std::size_t a = 0; a < this->N; ++a) {
    rotation[a][0] = -this->x_[a][1];
    rotation[a][1] = this->x_[a][0];
  }
  const auto force = this->product(end_rule(), 0, 0, this->zero_, rotation);
  double energy = 0;
  for (std::size_t a = 0; a < this->N; ++a)
    for (std::size_t d = 0; d < this->D; ++d) energy += rotation[a][d] * force[a][d];
  EXPECT_LT(std::abs(energy), this->exact ? 1e-15 : TypeParam::has_moduli ? 1e-6 : 1e-13);
}

}  // namespace
}  // namespace ixos
