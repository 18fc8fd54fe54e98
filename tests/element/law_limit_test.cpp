// States beyond the limit of a law are inadmissible in every element, as inverted ones are.
#include <gtest/gtest.h>

#include "element/elastic_kernel.hpp"
#include "element/element_nodes.hpp"
#include "element/enhanced_kernel.hpp"
#include "element/projected_dilatation_kernel.hpp"
#include "fem/reference_elements.hpp"
#include "material/catalogue.hpp"

namespace ixos {
namespace {

using test::ElasticKernel;

/// Simple shear gamma of a square: I1 - 3 = gamma^2, and J = 1.
template <class Kernel>
class LawLimitTest : public testing::Test {
 protected:
  using Nodal = typename Kernel::template Nodal<Pack>;

  LawLimitTest() {
    const auto square = test::ElementNodes<typename Kernel::Shape>::block({2.0, 2.0});
    for (std::size_t a = 0; a < Kernel::N; ++a)
      for (std::size_t d = 0; d < 2; ++d) x_[a][d] = square[a][d];
    geometry_ = Kernel::geometry(table_, x_);
  }

  Nodal sheared(double gamma) const {
    Nodal u{};
    for (std::size_t a = 0; a < Kernel::N; ++a) u[a][0] = gamma * x_[a][1];
    return u;
  }
  /// Whether the force on the way from one shear to another is admissible.
  bool is_admissible(double from, double to, const Rule& rule) const {
    return is_admissible(sheared(from), sheared(to), rule);
  }
  bool is_admissible(const Nodal& start, const Nodal& end, const Rule& rule) const {
    Nodal force{};
    return least(Kernel::add_force(material_, geometry_, {&start, nullptr, &end}, rule, force)) > 0;
  }

  AnyLaw<PlaneSpace> material_{make_elastic_law("Gent", {{"Limit", 4.0}})};
  typename Kernel::Table table_{product_rule(std::array<int, 2>{2, 2})};
  Nodal x_{};
  typename Kernel::template Geometry<Pack> geometry_;
};

using Kernels =
    testing::Types<ElasticKernel<Quad4, AnyLaw<PlaneSpace>>, MeanDilatationKernel<Quad4, AnyLaw<PlaneSpace>>,
                   ProjectedDilatationKernel<Quad9, AnyLaw<PlaneSpace>>, EnhancedKernel<Quad4, AnyLaw<PlaneSpace>>>;
TYPED_TEST_SUITE(LawLimitTest, Kernels);

TYPED_TEST(LawLimitTest, AStateBeyondItIsInadmissible) {
  EXPECT_TRUE(this->is_admissible(0, 1.99, end_rule()));
  EXPECT_FALSE(this->is_admissible(0, 2.01, end_rule()));
  EXPECT_FALSE(this->is_admissible(0, 50, end_rule()));
}

/// The end of a step stores energy, so it counts where the time points are within the limit.
TYPED_TEST(LawLimitTest, SoIsAStepThatEndsBeyondIt) {
  const Rule middle = point_rule({0.5}, {1});
  EXPECT_TRUE(this->is_admissible(1, 1.99, middle));
  EXPECT_FALSE(this->is_admissible(1, 2.01, middle));
}

/// Bent, a square of full integration shears and a square with modes does not. The law sees the latter's strain alone.
TEST(LawLimitModesTest, AreThoseOfTheStateWithItsModes) {
  using Kernel = EnhancedKernel<Quad4, AnyLaw<PlaneSpace>>;
  using Plain = ElasticKernel<Quad4, AnyLaw<PlaneSpace>>;
  const AnyLaw<PlaneSpace> material(make_elastic_law("Gent", {{"Limit", 0.1}, {"Poisson's Ratio", 0.0}}));
  const typename Kernel::Table table{product_rule(std::array<int, 2>{2, 2})};
  Kernel::Nodal<Pack> x{}, start{}, end{};
  for (std::size_t a = 0; a < Kernel::N; ++a)
    for (std::size_t d = 0; d < 2; ++d) x[a][d] = corners<2>()[a][d];
  const auto geometry = Kernel::geometry(table, x);
  const auto plain = Plain::geometry(table, x);
  const Rule middle = point_rule({0.5}, {1});
  int mended = 0, beyond = 0;
  for (double bend = 0.02; bend < 0.6; bend += 0.01) {
    for (std::size_t a = 0; a < Kernel::N; ++a) end[a][0] = bend * x[a][0] * x[a][1];
    const auto is_admissible = [&](const Rule& rule) {
      Kernel::Nodal<Pack> force{};
      return least(Kernel::add_force(material, geometry, {&start, nullptr, &end}, rule, force)) > 0;
    };
    const bool at_end = is_admissible(end_rule());
    EXPECT_EQ(is_admissible(middle), at_end) << bend;
    Plain::Nodal<Pack> force{};
    const bool without = least(Plain::add_force(material, plain, {&start, nullptr, &end}, end_rule(), force)) > 0;
    mended += at_end && !without ? 1 : 0;
    beyond += at_end ? 0 : 1;
  }
  EXPECT_GT(mended, 0);
  EXPECT_GT(beyond, 0);
}

TEST(LawLimitGradientTest, ADiscreteGradientBeyondItIsInadmissible) {
  using Kernel = ElasticKernel<Quad4, AnyLaw<PlaneSpace>>;
  const AnyLaw<PlaneSpace> material(make_elastic_law("Gent", {{"Limit", 4.0}}));
  const typename Kernel::Table table{product_rule(std::array<int, 2>{2, 2})};
  Kernel::Nodal<Pack> x{}, start{}, end{};
  for (std::size_t a = 0; a < Kernel::N; ++a)
    for (std::size_t d = 0; d < 2; ++d) x[a][d] = corners<2>()[a][d];
  const auto geometry = Kernel::geometry(table, x);
  Rule rule;
  rule.mean = Mean::DiscreteGradient;
  for (const double gamma : {1.99, 2.01}) {
    Kernel::Nodal<Pack> force{};
    for (std::size_t a = 0; a < Kernel::N; ++a) end[a][0] = gamma * x[a][1];
    EXPECT_EQ(least(Kernel::add_force(material, geometry, {&start, nullptr, &end}, rule, force)) > 0, gamma < 2);
    if (gamma < 2) {
      // The work on the way is the change of the energy.
      Pack work = 0.0;
      for (std::size_t a = 0; a < Kernel::N; ++a) work += force[a][0] * end[a][0];
      EXPECT_NEAR(work[0], Kernel::energy(material, geometry, end)[0], 1e-14 * work[0]);
    }
  }
}

}  // namespace
}  // namespace ixos
