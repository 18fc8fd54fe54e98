#include "interaction/catalogue.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "fem/quadrature.hpp"
#include "interaction/area_factor.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/obstacle.hpp"
#include "support/catalogue_walk.hpp"
#include "support/derivative.hpp"
#include "support/obstacle_geometry.hpp"
#include "support/refusal.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

using test::complete;
using test::derivative;

constexpr double gaps[] = {0.2, 0.2547093, 0.31, 0.5, 1.2};

class LawTest : public testing::TestWithParam<std::string> {
 protected:
  LawTest() : list_(complete(laws(), GetParam())), law_(laws().make(SceneNode(list_, ""))) {}
  Teuchos::ParameterList list_;
  std::shared_ptr<const GapLaw> law_;
};

TEST(LawCatalogueTest, EveryEntryIsWhole) {
  test::walk(laws(), {}, {}, [](const Teuchos::ParameterList& list, const LawEntry&) {
    const auto law = laws().make(SceneNode(list, ""));
    return std::vector<double>{law->energy(0.3)[0], law->traction(0.5)[0], law->stiffness(0.2)[0],
                               law->energy(0.02)[0]};
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

/// Returns the integral of f from a to b. Halves the interval until 10 and 20 Gauss points agree: tractions may have
/// kinks.
template <class Function>
double integral(const Function& f, double a, double b, double tolerance) {
  static const Quadrature rules[] = {gauss_legendre_unit(10), gauss_legendre_unit(20)};
  double sums[] = {0, 0};
  for (int rule : {0, 1})
    for (std::size_t q = 0; q < rules[rule].points.size(); ++q)
      sums[rule] += (b - a) * rules[rule].weights[q] * f(a + rules[rule].points[q] * (b - a));
  if (std::abs(sums[1] - sums[0]) <= tolerance || std::abs(b - a) < 1e-9) return sums[1];
  const double middle = (a + b) / 2;
  return integral(f, a, middle, tolerance / 2) + integral(f, middle, b, tolerance / 2);
}

/// Checks the three means over gaps from r0 to r1 by quadrature and differences.
void expect_means(const GapLaw& law, double r0, double r1) {
  SCOPED_TRACE(std::to_string(r0) + " to " + std::to_string(r1));
  const double scale = law.magnitude(std::min(r0, r1))[0];
  const auto traction = [&](double r) { return static_cast<double>(law.traction(r)[0]); };
  EXPECT_NEAR(law.mean_traction(r0, r1)[0] * (r1 - r0), integral(traction, r0, r1, 1e-13 * scale * std::abs(r1 - r0)),
              1e-12 * scale * std::abs(r1 - r0));
  const auto mean_at = [&](double s) { return -law.mean_traction(r0, r1 + s)[0]; };
  EXPECT_NEAR(derivative(mean_at, 1e-3 * r1), law.mean_stiffness(r0, r1)[0], 1e-7 * scale / r1);
  const auto potential_at = [&](double s) { return -law.mean_potential(r0, r1 + s)[0]; };
  EXPECT_NEAR(derivative(potential_at, 1e-3 * r1), law.mean_traction(r0, r1)[0], 1e-7 * scale);
}

TEST_P(LawTest, MeansAreMeans) {
  for (double r0 : gaps)
    for (double r1 : {0.22, 0.2547093, 0.9})
      if (r0 != r1) expect_means(*law_, r0, r1);
  // No digits are lost when the gap hardly moves.
  for (double r : gaps) {
    const double scale = law_->magnitude(r)[0];
    for (double ratio : {1 + 1e-12, 1.0, 1 - 1e-9}) {
      EXPECT_NEAR(law_->mean_traction(r, r * ratio)[0], law_->traction(r)[0], 1e-8 * scale);
      EXPECT_NEAR(law_->mean_stiffness(r, r * ratio)[0], law_->stiffness(r)[0] / 2, 1e-8 * scale / r);
    }
    EXPECT_NEAR(law_->mean_traction(r, r * (1 + 1e-12))[0], law_->traction(r)[0], 1e-11 * scale);
    EXPECT_NEAR(law_->mean_stiffness(r, r * (1 + 1e-12))[0], law_->stiffness(r)[0] / 2, 1e-10 * scale / r);
    EXPECT_NEAR(law_->mean_potential(r, r)[0], 0, 1e-16);
  }
}

TEST_P(LawTest, ACutoffKeepsTheMeans) {
  const auto cut = law_->cut_off(0.6);
  // Inside, across the range in both directions, and beyond.
  for (const auto& [r0, r1] : {std::pair{0.3, 0.35}, std::pair{0.3, 0.9}, std::pair{0.9, 0.3}, std::pair{0.7, 0.31},
                               std::pair{0.6, 0.3}, std::pair{0.6, 0.9}, std::pair{0.8, 0.9}})
    expect_means(*cut, r0, r1);
}

TEST_P(LawTest, NamedGapsAreWhereTheyShouldBe) {
  const double equilibrium = law_->equilibrium_gap(), adhesion = law_->adhesion_gap();
  EXPECT_GT(equilibrium, 0) << "it is a scale of small gaps";
  const double largest = -law_->traction(adhesion)[0];
  bool repels = false;
  for (double r = law_->has_history() ? -0.1 : 0.01; r < 3; r += 0.001) {
    const double traction = law_->traction(r)[0];
    repels = repels || traction > 0;
    EXPECT_GE(traction, -largest * (1 + 1e-13) - 1e-16) << r;
  }
  EXPECT_EQ(law_->repels(), repels);
  if (!repels || largest == 0 || law_->has_history()) return;  // a bond pushes overlaps away only
  EXPECT_NEAR(law_->traction(equilibrium)[0], 0, 1e-14 * law_->magnitude(equilibrium)[0] + 1e-17);
  EXPECT_GT(largest, 0);
  EXPECT_NEAR(law_->stiffness(adhesion)[0], 0, 1e-13 * law_->magnitude(adhesion)[0] / adhesion + 1e-15);
}

TEST_P(LawTest, TheAttractionDoesTheWorkOfAdhesion) {
  const double start = law_->repels() && !law_->has_history() ? law_->equilibrium_gap() : 0, far = 1e4;
  const auto traction = [&](double l) { return std::exp(l) * law_->traction(start + std::exp(l) - 1e-3)[0]; };
  const double work = -integral(traction, std::log(1e-3), std::log(far), 1e-15);
  EXPECT_NEAR(work_of_adhesion(*law_), work - law_->energy(start + far - 1e-3)[0], 1e-13);
}

TEST_P(LawTest, ACutOffShiftsTheForce) {
  const double range = 2;
  const auto cut = law_->cut_off(range);
  EXPECT_EQ(cut->range(), std::min(range, law_->range()));
  EXPECT_NEAR(cut->traction(0.3)[0], law_->traction(0.3)[0] - law_->traction(range)[0], 1e-15);
  EXPECT_EQ(cut->traction(2.1)[0], 0);
  EXPECT_EQ(cut->domain(), law_->domain());
  EXPECT_EQ(cut->repels(), law_->repels());
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
  /// Returns a tolerance for second derivatives. Where a search found the closest point, they are those before its last
  /// step.
  double bend_tolerance() const { return std::isfinite(obstacle_->reach()) ? 1e-8 : 1e-10; }
  std::size_t dimension_;
  Teuchos::ParameterList list_;
  std::shared_ptr<const Obstacle> obstacle_;
};

TEST(ObstacleCatalogueTest, EveryEntryIsWhole) {
  // In two dimensions these have no use, or none alone. RoundObstacleTest, GraphObstacleTest and HeightFieldTest vary
  // them.
  const std::set<std::string> unused{"Cylinder/Axis",           "Sine Wall/Direction",    "Sine Wall/Second Amplitude",
                                     "Sine Wall/Second Period", "Height Field/Direction", "Height Field/Metre"};
  Teuchos::ParameterList given;
  given.set("File", std::string(IXOS_TEST_DIRECTORY "/interaction/hills.txt"));
  given.set("Spacing", Teuchos::Array<double>(Teuchos::tuple<double>(0.25, 1.0)));
  test::walk(obstacles(), given, unused, [](const Teuchos::ParameterList& list, const ObstacleEntry&) {
    const auto obstacle = obstacles().make(SceneNode(list, ""), 2);
    const double factor = obstacle->area_factor(2) ? obstacle->area_factor(2)->radius : 0;
    return std::vector<double>{obstacle->at({1.0, 2.0, 0.0}).gap[0], obstacle->at({-1.0, 3.0, 0.0}).gap[0],
                               obstacle->at({5.0, -3.0, 0.0}).gap[0], factor};
  });
}

TEST_P(ObstacleTest, NormalAndBendAreDerivativesOfTheGap) {
  const PackPoint x = point(1.3, 2.4, 1.9);
  const ObstacleGap found = obstacle_->at(x);
  double square = 0;
  for (std::size_t i = 0; i < dimension_; ++i) {
    square += found.normal[i][0] * found.normal[i][0];
    EXPECT_NEAR(derivative([&](double s) { return double(obstacle_->at(moved(x, i, s)).gap[0]); }, 1e-3),
                found.normal[i][0], 1e-11);
    for (std::size_t j = 0; j < dimension_; ++j)
      EXPECT_NEAR(derivative([&](double s) { return double(obstacle_->at(moved(x, j, s)).normal[i][0]); }, 1e-3),
                  found.bend[i][j][0], bend_tolerance());
  }
  EXPECT_NEAR(square, 1, 1e-15);
}

// Before the surface and within the obstacle.
TEST_P(ObstacleTest, GapAndNormalAloneAreTheSame) {
  for (const PackPoint& x :
       {point(1.3, 2.4, 1.9), point(0.7, 0.4, 0.3), point(0.5, 1.5, 0.05), point(0.4, -0.3, -0.3)}) {
    const ObstacleGap found = obstacle_->at(x), without_bend = obstacle_->gap_and_normal(x);
    const double gap = found.gap[0], lower = obstacle_->gap_or_less(x)[0];
    EXPECT_NEAR(obstacle_->gap(x)[0], gap, 1e-15);
    EXPECT_NEAR(without_bend.gap[0], gap, 1e-15);
    for (std::size_t i = 0; i < dimension_; ++i) EXPECT_NEAR(without_bend.normal[i][0], found.normal[i][0], 1e-15);
    EXPECT_LE(lower, gap + 1e-15);
    EXPECT_EQ(lower > 0, gap > 0);
  }
}

TEST_P(ObstacleTest, TheMeanNormalMeasuresTheChangeOfTheGap) {
  const PackPoint x0 = point(1.3, 2.4, 1.9);
  for (const PackPoint& x1 : {point(1.3, 2.4001, 1.9), point(1.5, 2.3, 1.8), point(-1.0, 3.5, 1.2)}) {
    const MeanGap mean = obstacle_->mean(x0, x1);
    double change = 0;
    for (std::size_t i = 0; i < dimension_; ++i) change += mean.normal[i][0] * (x1[i][0] - x0[i][0]);
    EXPECT_NEAR(change, obstacle_->at(x1).gap[0] - obstacle_->at(x0).gap[0], 1e-14);
    for (std::size_t i = 0; i < dimension_; ++i)
      for (std::size_t j = 0; j < dimension_; ++j)
        EXPECT_NEAR(
            derivative([&](double s) { return double(obstacle_->mean(x0, moved(x1, j, s)).normal[i][0]); }, 1e-3),
            mean.slope[i][j][0], bend_tolerance());
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

// The force per reference area is f = -T n. Its tangent is psi'' n n^T - T H; that of the mean force between two
// points, by the second one, is mean_stiffness nbar n1^T - mean_traction slope.
TEST_P(ObstacleTest, TangentsBeforeEveryLawAreDerivativesOfTheForce) {
  for (const std::string& name : law_names()) {
    SCOPED_TRACE(name);
    const Teuchos::ParameterList list = complete(laws(), name);
    const auto law = laws().make(SceneNode(list, ""));
    // Places at about the largest attraction and nearer, on the way down to the obstacle.
    const PackPoint start = point(0.4, 2.6, 1.6);
    PackPoint down = obstacle_->at(start).normal;
    for (const double gap : {0.3, 0.5}) {
      const Pack step = gap - obstacle_->at(start).gap;
      PackPoint x = start;
      for (std::size_t i = 0; i < 3; ++i) x[i] += step * down[i];
      if (obstacle_->at(x).gap[0] < 0.15) continue;  // the normal there is another one
      const PackPoint x0 = point(double(x[0][0]) + 0.02, double(x[1][0]) + 0.1, double(x[2][0]) + 0.1);
      const ObstacleGap found = obstacle_->at(x);
      const double scale = law->magnitude(found.gap)[0] / double(found.gap[0]);
      const auto force = [&](const PackPoint& at, std::size_t i) {
        const ObstacleGap there = obstacle_->at(at);
        return double(Pack(-law->traction(there.gap) * there.normal[i])[0]);
      };
      const Pack gap0 = obstacle_->at(x0).gap;
      const auto mean_force = [&](const PackPoint& at, std::size_t i) {
        return double(Pack(-law->mean_traction(gap0, obstacle_->at(at).gap) * obstacle_->mean(x0, at).normal[i])[0]);
      };
      const MeanGap mean = obstacle_->mean(x0, x);
      for (std::size_t i = 0; i < dimension_; ++i)
        for (std::size_t j = 0; j < dimension_; ++j) {
          const Pack tangent = law->stiffness(found.gap) * found.normal[i] * found.normal[j] -
                               law->traction(found.gap) * found.bend[i][j];
          EXPECT_NEAR(derivative([&](double s) { return force(moved(x, j, s), i); }, 1e-4), double(tangent[0]),
                      1e-6 * scale);
          const Pack mean_tangent = law->mean_stiffness(gap0, found.gap) * mean.normal[i] * found.normal[j] -
                                    law->mean_traction(gap0, found.gap) * mean.slope[i][j];
          EXPECT_NEAR(derivative([&](double s) { return mean_force(moved(x, j, s), i); }, 1e-4),
                      double(mean_tangent[0]), 1e-6 * scale);
        }
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
