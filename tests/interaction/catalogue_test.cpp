#include "interaction/catalogue.hpp"

#include "fem/quadrature.hpp"
#include "support/catalogue_walk.hpp"
#include "support/derivative.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::derivative;

template <class Catalogue>
Teuchos::ParameterList complete(const Catalogue& catalogue, const std::string& name) {
  Teuchos::ParameterList valid, user;
  catalogue.declare(valid);
  user.set(catalogue.choice(), name);
  if (name == "Sphere") user.sublist(name).set("Radius", 2.0);
  return validated(user, valid);
}

constexpr double gaps[] = {0.2, 0.2547093, 0.31, 0.5, 1.2};

class LawTest : public testing::TestWithParam<std::string> {
 protected:
  LawTest() : list_(complete(laws(), GetParam())), law_(laws().make(SceneNode(list_, ""))) {}
  Teuchos::ParameterList list_;
  std::shared_ptr<const GapLaw> law_;
};

TEST(LawCatalogueTest, EveryEntryIsWhole) {
  // VanDerWaalsConstantsTest tests the other constants of this law.
  const std::set<std::string> other{"Van der Waals/Constants", "Van der Waals/Hamaker Constant",
                                    "Van der Waals/Length Scale", "Van der Waals/Work of Adhesion",
                                    "Van der Waals/Strength"};
  test::walk(laws(), {}, other, [](const Teuchos::ParameterList& list, const LawEntry&) {
    const auto law = laws().make(SceneNode(list, ""));
    return std::vector<double>{law->energy(0.3)[0], law->traction(0.5)[0], law->stiffness(0.2)[0]};
  });
}

/// The van der Waals law from other constants: those of the paper, as one knows them elsewhere.
std::shared_ptr<const GapLaw> van_der_waals(const std::string& constants, const std::string& first, double a,
                                            const std::string& second, double b) {
  Teuchos::ParameterList valid, user;
  laws().declare(valid);
  user.set("Constants", constants);
  user.set(first, a);
  user.set(second, b);
  const Teuchos::ParameterList list = validated(user, valid);
  EXPECT_FALSE(list.isParameter("Gamma L"));
  return laws().make(SceneNode(list, ""));
}

TEST(VanDerWaalsConstantsTest, HamakersConstantGivesTheAttraction) {
  const double hamaker = 0.05, length = 0.3;
  const auto law = van_der_waals("Hamaker", "Hamaker Constant", hamaker, "Length Scale", length);
  EXPECT_NEAR(law->equilibrium_gap(), std::pow(15.0, -1.0 / 6) * length, 1e-15);
  const double far = 50;  // the repulsion is (r0/r)^6/15 of this
  EXPECT_NEAR(law->energy(far)[0] * -12 * M_PI * far * far, hamaker, 1e-12 * hamaker);
}

TEST(VanDerWaalsConstantsTest, WorkOfAdhesionAndStrengthAreThoseOfTheLaw) {
  const double work = 0.02, strength = 0.07;
  const auto law = van_der_waals("Adhesion", "Work of Adhesion", work, "Strength", strength);
  EXPECT_NEAR(-law->energy(law->equilibrium_gap())[0], work, 1e-15);
  EXPECT_NEAR(-law->traction(law->adhesion_gap())[0], strength, 1e-15);
}

TEST(VanDerWaalsConstantsTest, MixedAndMissingConstantsAreRefused) {
  Teuchos::ParameterList valid, user;
  laws().declare(valid);
  const auto refused = [&](const std::string& words) {
    test::expect_contains(test::refusal([&] { validated(user, valid); }), words);
  };
  user.set("Constants", std::string("Hamaker"));
  refused("Hamaker Constant is missing");
  user.set("Hamaker Constant", 0.05);
  user.set("Gamma L", 2.5);
  refused("\"Gamma L\" belongs to Constants \"Ratios\", but Constants is \"Hamaker\"");
  user.remove("Gamma L");
  user.set("Law", std::string("Morse"));
  refused("belongs to Law \"Van der Waals\", but Law is \"Morse\"");
}

TEST_P(LawTest, TractionAndStiffnessAreDerivativesOfTheEnergy) {
  for (double r : gaps) {
    const double scale = law_->magnitude(r)[0];
    EXPECT_NEAR(derivative([&](double s) { return -law_->energy(r + s)[0]; }, 1e-3 * r), law_->traction(r)[0],
                1e-8 * scale);
    EXPECT_NEAR(derivative([&](double s) { return -law_->traction(r + s)[0]; }, 1e-3 * r), law_->stiffness(r)[0],
                1e-7 * scale / r);
  }
}

TEST_P(LawTest, MeansAreMeans) {
  const Quadrature gauss = gauss_legendre_unit(40);
  for (double r0 : gaps)
    for (double r1 : {0.22, 0.2547093, 0.9}) {
      const double scale = law_->magnitude(std::min(r0, r1))[0];
      double mean = 0;
      for (std::size_t q = 0; q < gauss.points.size(); ++q)
        mean += gauss.weights[q] * law_->traction(r0 + gauss.points[q] * (r1 - r0))[0];
      EXPECT_NEAR(law_->mean_traction(r0, r1)[0], mean, 1e-12 * scale);
      const auto mean_at = [&](double s) { return -law_->mean_traction(r0, r1 + s)[0]; };
      EXPECT_NEAR(derivative(mean_at, 1e-3 * r1), law_->mean_stiffness(r0, r1)[0], 1e-7 * scale / r1);
      const auto potential_at = [&](double s) { return -law_->mean_potential(r0, r1 + s)[0]; };
      EXPECT_NEAR(derivative(potential_at, 1e-3 * r1), law_->mean_traction(r0, r1)[0], 1e-7 * scale);
    }
  // No digits are lost when the gap hardly moves.
  for (double r : gaps) {
    const double scale = law_->magnitude(r)[0];
    EXPECT_NEAR(law_->mean_traction(r, r * (1 + 1e-12))[0], law_->traction(r)[0], 1e-11 * scale);
    EXPECT_NEAR(law_->mean_stiffness(r, r * (1 + 1e-12))[0], law_->stiffness(r)[0] / 2, 1e-10 * scale / r);
    EXPECT_NEAR(law_->mean_potential(r, r)[0], 0, 1e-16);
  }
}

TEST_P(LawTest, NamedGapsAreWhereTheyShouldBe) {
  const double equilibrium = law_->equilibrium_gap(), adhesion = law_->adhesion_gap();
  EXPECT_GT(equilibrium, 0) << "it is a scale of small gaps";
  EXPECT_NEAR(law_->traction(equilibrium)[0], 0, 1e-14 * law_->magnitude(equilibrium)[0] + 1e-17);
  EXPECT_LT(law_->traction(adhesion)[0], 0);
  EXPECT_NEAR(law_->stiffness(adhesion)[0], 0, 1e-13 * law_->magnitude(adhesion)[0] / adhesion + 1e-15);
}

TEST_P(LawTest, ACutOffShiftsTheForce) {
  const double range = 2;
  const auto cut = law_->cut_off(range);
  EXPECT_EQ(cut->range(), range);
  EXPECT_NEAR(cut->traction(0.5)[0], law_->traction(0.5)[0] - law_->traction(range)[0], 1e-15);
  EXPECT_EQ(cut->traction(2.1)[0], 0);
  EXPECT_EQ(cut->domain(), law_->domain());
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const LawEntry& entry : laws().entries()) names.push_back(entry.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(All, LawTest, testing::ValuesIn(law_names()));

class ObstacleTest : public testing::TestWithParam<std::tuple<std::string, std::size_t>> {
 protected:
  ObstacleTest()
      : dimension_(std::get<1>(GetParam())),
        list_(complete(obstacles(), std::get<0>(GetParam()))),
        obstacle_(obstacles().make(SceneNode(list_, ""), dimension_)) {}
  PackPoint point(double x, double y, double z) const { return {x, y, dimension_ == 3 ? z : 0.0}; }
  static PackPoint moved(PackPoint x, std::size_t axis, double step) {
    x[axis] += step;
    return x;
  }
  std::size_t dimension_;
  Teuchos::ParameterList list_;
  std::shared_ptr<const Obstacle> obstacle_;
};

TEST(ObstacleCatalogueTest, EveryEntryIsWhole) {
  test::walk(obstacles(), {}, {}, [](const Teuchos::ParameterList& list, const ObstacleEntry&) {
    const auto obstacle = obstacles().make(SceneNode(list, ""), 2);
    return std::vector<double>{obstacle->at({3.0, 4.0, 0.0}).gap[0], obstacle->at({-1.0, 9.0, 0.0}).gap[0]};
  });
}

TEST_P(ObstacleTest, NormalAndBendAreDerivativesOfTheGap) {
  const PackPoint x = point(1.3, 2.4, 1.9);
  const Sight sight = obstacle_->at(x);
  double square = 0;
  for (std::size_t i = 0; i < dimension_; ++i) {
    square += sight.normal[i][0] * sight.normal[i][0];
    EXPECT_NEAR(derivative([&](double s) { return double(obstacle_->at(moved(x, i, s)).gap[0]); }, 1e-3),
                sight.normal[i][0], 1e-11);
    for (std::size_t j = 0; j < dimension_; ++j)
      EXPECT_NEAR(derivative([&](double s) { return double(obstacle_->at(moved(x, j, s)).normal[i][0]); }, 1e-3),
                  sight.bend[i][j][0], 1e-10);
  }
  EXPECT_NEAR(square, 1, 1e-15);
}

TEST_P(ObstacleTest, TheMeanNormalMeasuresTheChangeOfTheGap) {
  const PackPoint x0 = point(1.3, 2.4, 1.9);
  for (const PackPoint& x1 : {point(1.3, 2.4001, 1.9), point(1.5, 2.3, 1.8), point(-1.0, 3.5, 1.2)}) {
    const MeanSight mean = obstacle_->mean(x0, x1);
    double change = 0;
    for (std::size_t i = 0; i < dimension_; ++i) change += mean.normal[i][0] * (x1[i][0] - x0[i][0]);
    EXPECT_NEAR(change, obstacle_->at(x1).gap[0] - obstacle_->at(x0).gap[0], 1e-14);
    for (std::size_t i = 0; i < dimension_; ++i)
      for (std::size_t j = 0; j < dimension_; ++j)
        EXPECT_NEAR(
            derivative([&](double s) { return double(obstacle_->mean(x0, moved(x1, j, s)).normal[i][0]); }, 1e-3),
            mean.slope[i][j][0], 1e-10);
  }
}

TEST_P(ObstacleTest, TheLeastGapIsThatOfThePath) {
  const PackPoint x0 = point(-1.5, 2.2, 0.4);
  for (const PackPoint& x1 : {point(1.5, 2.4, 0.2), point(1.8, 2.3, 1.8), point(-1.0, 4.5, 0.2), x0}) {
    double length = 0, sampled = obstacle_->at(x0).gap[0];
    for (std::size_t i = 0; i < 3; ++i) length += std::pow(x1[i][0] - x0[i][0], 2);
    length = std::sqrt(length);
    for (int k = 1; k <= 1000; ++k) {
      PackPoint x;
      for (std::size_t i = 0; i < 3; ++i) x[i] = x0[i] + (k / 1000.0) * (x1[i] - x0[i]);
      sampled = std::min(sampled, double(obstacle_->at(x).gap[0]));
    }
    const double found = obstacle_->least_gap(x0, x1)[0];
    EXPECT_LE(found, std::min(obstacle_->at(x0).gap[0], obstacle_->at(x1).gap[0]) + 1e-14);
    EXPECT_GE(found, (obstacle_->at(x0).gap[0] + obstacle_->at(x1).gap[0] - length) / 2 - 1e-14) << "Lipschitz";
    EXPECT_NEAR(found, sampled, 0.1 * length + 1e-14);
  }
}

TEST_P(ObstacleTest, AnAdmissibleStepKeepsTheGap) {
  const PackPoint x = point(0.4, 2.6, 0.3);
  const Pack least = 0.1;
  for (const PackPoint& d : {point(0.1, -5, 0), point(2, -2.2, -0.4), point(1, 1, 1), point(0, 0, 0)}) {
    const Pack step = obstacle_->admissible_step(x, d, least);
    EXPECT_GE(step[0], 0);
    EXPECT_LE(step[0], 1);
    PackPoint there;
    for (std::size_t i = 0; i < 3; ++i) there[i] = x[i] + step * d[i];
    EXPECT_GE(obstacle_->at(there).gap[0], 0.1 - 1e-12);
    // Short of the whole step, the way to the bound is nearly used up.
    if (step[0] < 1) {
      EXPECT_LT(obstacle_->at(there).gap[0], 0.2);
    }
  }
}

std::vector<std::string> obstacle_names() {
  std::vector<std::string> names;
  for (const ObstacleEntry& entry : obstacles().entries()) names.push_back(entry.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(All, ObstacleTest,
                         testing::Combine(testing::ValuesIn(obstacle_names()), testing::Values(2U, 3U)));

}  // namespace
}  // namespace ixos
