#include "material/catalogue.hpp"

#include <array>

#include "material/elastic_law.hpp"
#include "support/catalogue_walk.hpp"
#include "support/derivative.hpp"

namespace ixos {
namespace {

using test::derivative;

template <std::size_t D>
using Matrix = Small<Pack, D>;

/// A moderate displacement gradient.
template <std::size_t D>
Matrix<D> gradient(double size) {
  Matrix<D> h;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) h[i][j] = size * std::sin(1.0 + 3.0 * double(i) + 1.7 * double(j));
  return h;
}

template <std::size_t D>
void check(const ElasticLaw& law) {
  const Matrix<D> h = gradient<D>(0.2), h0 = gradient<D>(-0.1);
  Matrix<D> p, same;
  Small<Pack, D * D> moduli;
  law.stress(h, p);
  law.stress_and_moduli(h, same, moduli);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      EXPECT_NEAR(p[i][j][0], same[i][j][0], 1e-14);
      const auto moved = [&](double step) {
        Matrix<D> there = h;
        there[i][j] += step;
        return there;
      };
      EXPECT_NEAR(derivative([&](double s) { return double(law.energy(moved(s))[0]); }), p[i][j][0], 1e-9);
      for (std::size_t k = 0; k < D * D; ++k)
        EXPECT_NEAR(derivative([&](double s) {
                      Matrix<D> stress;
                      law.stress(moved(s), stress);
                      return double(stress[k / D][k % D][0]);
                    }),
                    moduli[k][i * D + j][0], 1e-8);
    }
  if (!law.has_discrete_gradient()) return;
  law.discrete_gradient(h0, h, p);
  double work = 0;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) work += p[i][j][0] * (h[i][j][0] - h0[i][j][0]);
  EXPECT_NEAR(work, law.energy(h)[0] - law.energy(h0)[0], 1e-14);
  law.discrete_gradient_moduli(h0, h, moduli);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j)
      for (std::size_t k = 0; k < D * D; ++k)
        EXPECT_NEAR(derivative([&](double s) {
                      Matrix<D> there = h, stress;
                      there[i][j] += s;
                      law.discrete_gradient(h0, there, stress);
                      return double(stress[k / D][k % D][0]);
                    }),
                    moduli[k][i * D + j][0], 1e-8);
}

/// Returns the law with its defaults.
std::shared_ptr<const ElasticLaw> made(const ElasticEntry& entry) {
  Teuchos::ParameterList valid, user;
  elastic_laws().declare(valid);
  user.set("Model", entry.name);
  const Teuchos::ParameterList complete = validated(user, valid);
  return elastic_laws().make(SceneNode(complete, ""));
}

TEST(MaterialCatalogueTest, EveryEntryIsWhole) {
  test::walk(elastic_laws(), {}, {}, [](const Teuchos::ParameterList& list, const ElasticEntry&) {
    const auto law = elastic_laws().make(SceneNode(list, ""));
    return std::vector<double>{law->energy(gradient<3>(0.1))[0], law->out_of_plane_stress(gradient<2>(0.1))[0]};
  });
}

TEST(MaterialCatalogueTest, StressAndModuliAreDerivativesOfTheEnergy) {
  for (const ElasticEntry& entry : elastic_laws().entries()) {
    SCOPED_TRACE(entry.name);
    check<2>(*made(entry));
    check<3>(*made(entry));
  }
}

TEST(MaterialCatalogueTest, PlaneStrainIsThreeDimensionsWithoutTheThirdDirection) {
  for (const ElasticEntry& entry : elastic_laws().entries()) {
    SCOPED_TRACE(entry.name);
    const auto law = made(entry);
    const Matrix<2> h = gradient<2>(0.2);
    Matrix<3> same{}, p3;
    Matrix<2> p2;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) same[i][j] = h[i][j];
    const Pack jacobian = law->stress(same, p3);
    law->stress(h, p2);
    EXPECT_NEAR(law->energy(h)[0], law->energy(same)[0], 1e-15);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) EXPECT_NEAR(p2[i][j][0], p3[i][j][0], 1e-14);
    EXPECT_NEAR(law->out_of_plane_stress(h)[0], (p3[2][2] / jacobian)[0], 1e-14);
  }
}

/// All laws have Hooke's moduli at small strains.
TEST(MaterialCatalogueTest, SmallStrainsAreHookes) {
  for (const ElasticEntry& entry : elastic_laws().entries()) {
    SCOPED_TRACE(entry.name);
    const auto law = made(entry);
    const Lame lame = law->lame();
    Matrix<3> none{}, p;
    Small<Pack, 9> moduli;
    law->stress_and_moduli(none, p, moduli);
    EXPECT_NEAR(moduli[0][0][0], lame.lambda + 2 * lame.mu, 1e-14);
    EXPECT_NEAR(moduli[0][4][0], lame.lambda, 1e-14);
    EXPECT_NEAR(moduli[1][1][0], lame.mu, 1e-14);
    EXPECT_NEAR(moduli[1][3][0], lame.mu, 1e-14);
  }
}

}  // namespace
}  // namespace ixos
