// The laws of rubber as a scene makes them: numbers of 60-digit arithmetic and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"

namespace ixos {
namespace {

using Matrix = Small<Pack, 3>;

/// Laws with the constants of the table.
std::shared_ptr<const ElasticLaw> law(const std::string& name, double poisson, const std::string& volumetric) {
  Settings settings{{"Poisson's Ratio", poisson}, {"Volumetric Energy", volumetric.c_str()}};
  const auto add = [&](const Settings& own) { settings.insert(settings.end(), own.begin(), own.end()); };
  if (name == "Mooney-Rivlin") add({{"C10", 0.35}, {"C01", 0.15}});
  if (name == "Yeoh") add({{"C1", 0.5}, {"C2", -0.05}, {"C3", 0.02}});
  if (name == "Gent") add({{"Shear Modulus", 1.0}, {"Limit", 5.0}});
  if (name == "Ogden") add({{"Moduli", std::vector<double>{1.5, -0.1}}, {"Exponents", std::vector<double>{1.3, -2.0}}});
  return make_elastic_law(name, settings);
}
const std::vector<std::string> names{"Mooney-Rivlin", "Yeoh", "Gent", "Ogden"};
const std::vector<std::string> volumetric{"Logarithm", "Convex"};

Matrix sample(double size) {
  const Small<double, 3> h{{{0.3, -0.2, 0.25}, {0.5, -0.4, 0.1}, {-0.15, 0.35, 0.45}}};
  Matrix result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = size * h[i][j];
  return result;
}

struct Row {
  const char* law;
  const char* volumetric;
  double energy[3], stress[3];  // W and P_01 at 1e-8, 1e-3 and 1 times the sample
};
// Output of law_values.py: the laws as written in I1, I2, J and the eigenvalues of C, 60 digits; nu = 0.3.
const std::vector<Row> table{{"Mooney-Rivlin",
                              "Logarithm",
                              {6.95624998045178295e-17, 6.95429655755932355e-7, 0.592954478820603134},
                              {2.99999997790000009e-9, 0.000299779278270306743, 0.372590133627587843}},
                             {"Mooney-Rivlin",
                              "Convex",
                              {6.9562499835483107e-17, 6.95460593624870417e-7, 0.607870860545365637},
                              {2.99999997789999996e-9, 0.000299779145607579845, 0.27081674716158025}},
                             {"Yeoh",
                              "Logarithm",
                              {6.95624997520914437e-17, 6.95377152834743158e-7, 0.504378511166740582},
                              {2.99999997325000017e-9, 0.000299732691345922406, 0.203770508662067265}},
                             {"Yeoh",
                              "Convex",
                              {6.95624997830567212e-17, 6.9540809070368122e-7, 0.519294892891503086},
                              {2.99999997325000004e-9, 0.000299732558683195508, 0.101997122196059666}},
                             {"Gent",
                              "Logarithm",
                              {6.9562499752091445e-17, 6.95377279515454737e-7, 0.578360752349697476},
                              {2.99999997325000031e-9, 0.000299732826459285466, 0.379541545010721744}},
                             {"Gent",
                              "Convex",
                              {6.95624997830567225e-17, 6.95408217384392798e-7, 0.593277134074459981},
                              {2.99999997325000017e-9, 0.000299732693796558568, 0.277768158544714145}},
                             {"Ogden",
                              "Logarithm",
                              {7.47796872807912768e-17, 7.47577782533390244e-7, 0.603529272959734914},
                              {3.22499997543843786e-9, 0.000322254648458861955, 0.320395781383478112}},
                             {"Ogden",
                              "Convex",
                              {7.47796873140789501e-17, 7.4761104074249866e-7, 0.619564383313854607},
                              {3.22499997543843772e-9, 0.00032225450584643054, 0.210989390932519939}}};

TEST(RubberLawsTest, EnergyAndStressKeepTheirDigitsAtAllStrains) {
  const double sizes[] = {1e-8, 1e-3, 1};
  for (const Row& row : table)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto rubber = law(row.law, 0.3, row.volumetric);
      Matrix p;
      rubber->stress(sample(sizes[k]), p);
      EXPECT_NEAR(rubber->energy(sample(sizes[k]))[0], row.energy[k], 4e-15 * row.energy[k]) << row.law << sizes[k];
      EXPECT_NEAR(p[0][1][0], row.stress[k], 2e-14 * row.stress[k]) << row.law << sizes[k];
    }
}

/// The nominal stress of a bar with free sides: at J = 1 the pressure follows from them.
double incompressible_bar(const ElasticLaw& rubber, double stretch) {
  Matrix h{}, p;
  const double across = 1 / std::sqrt(stretch);
  h[0][0] = stretch - 1;
  h[1][1] = h[2][2] = across - 1;
  rubber.stress(h, p);
  return p[0][0][0] - p[1][1][0] * across / stretch;
}

TEST(RubberLawsTest, AnIncompressibleBarAtStretchTwoHasTheTabulatedStress) {
  const auto ogden =
      make_elastic_law("Ogden", {{"Moduli", std::vector<double>{2 / 1.3}}, {"Exponents", std::vector<double>{1.3}}});
  const auto neo_hooke = make_elastic_law("Neo-Hooke", {{"Young's Modulus", 2.4}, {"Poisson's Ratio", 0.2}});
  EXPECT_NEAR(incompressible_bar(*neo_hooke, 2), 1.750000, 1e-14);
  EXPECT_NEAR(incompressible_bar(*law("Mooney-Rivlin", 0.2, "Logarithm"), 2), 1.487500, 1e-14);
  EXPECT_NEAR(incompressible_bar(*law("Gent", 0.2, "Logarithm"), 2), 35.0 / 12, 1e-14);
  EXPECT_NEAR(incompressible_bar(*ogden, 2), (std::pow(2, 0.3) - std::pow(2, -1.65)) * 2 / 1.3, 1e-14);
  EXPECT_NEAR(incompressible_bar(*ogden, 2), 1.403853, 5e-7);
  // Yeoh: 2 W_x (l - l^-2) at x = l^2 + 2/l - 3 = 2.
  EXPECT_NEAR(incompressible_bar(*law("Yeoh", 0.2, "Convex"), 2), 2 * (0.5 - 0.2 + 0.24) * 1.75, 1e-14);
}

/// The sides of a compressible bar become free by Newton's method; the difference is of the order of mu/K.
TEST(RubberLawsTest, ANearlyIncompressibleBarIsCloseToTheIncompressibleOne) {
  for (const std::string& name : names)
    for (const std::string& form : volumetric) {
      const auto rubber = law(name, 0.4999, form);
      Matrix h{}, p;
      Small<Pack, 9> moduli;
      h[0][0] = 1;
      double across = std::sqrt(0.5) - 1;
      for (int k = 0; k < 20; ++k) {
        h[1][1] = h[2][2] = across;
        EXPECT_GT(rubber->stress_and_moduli(h, p, moduli)[0], 0);
        across -= p[1][1][0] / (moduli[4][4][0] + moduli[4][8][0]);
      }
      EXPECT_NEAR(p[1][1][0], 0, 1e-11) << name;
      const double expected = incompressible_bar(*rubber, 2);
      EXPECT_NEAR(p[0][0][0], expected, 1e-3 * expected) << name << form;
      EXPECT_GT(std::abs(p[0][0][0] - expected), 1e-6) << name << form;
    }
}

TEST(RubberLawsTest, TurningTheBodyTurnsTheStressAlone) {
  const double c = std::cos(2.0), s = std::sin(2.0);
  const auto turned = [&](const Matrix& m, double one) {  // Q (m + one I) - one I, about the last axis
    Matrix result = m;
    for (std::size_t j = 0; j < 3; ++j) {
      const Pack x = m[0][j] + (j == 0 ? one : 0.0), y = m[1][j] + (j == 1 ? one : 0.0);
      result[0][j] = c * x - s * y - (j == 0 ? one : 0.0);
      result[1][j] = s * x + c * y - (j == 1 ? one : 0.0);
    }
    return result;
  };
  for (const std::string& name : names)
    for (const double size : {1e-6, 0.1, 1.0}) {
      const auto rubber = law(name, 0.45, "Logarithm");
      Matrix p, q;
      rubber->stress(sample(size), p);
      rubber->stress(turned(sample(size), 1), q);
      p = turned(p, 0);
      EXPECT_NEAR(rubber->energy(turned(sample(size), 1))[0], rubber->energy(sample(size))[0], 1e-14 * size) << name;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(p[i][j][0], q[i][j][0], 3e-14) << name;
    }
}

/// x = gamma^2 in simple shear: the limit is at gamma = sqrt(5).
TEST(RubberLawsTest, GentsLimitIsInadmissible) {
  const auto gent = law("Gent", 0.4999, "Logarithm");
  const auto sheared = [](double gamma) {
    Matrix h{};
    h[0][1] = gamma;
    return h;
  };
  const double limit = std::sqrt(5.0);
  for (const double room : {1e-2, 1e-6, 1e-10}) {
    const Matrix h = sheared(limit * (1 - room));
    const double x = h[0][1][0] * h[0][1][0];
    Matrix p;
    EXPECT_GT(gent->stress(h, p)[0], 0);
    EXPECT_GT(gent->admissibility(h)[0], 0);
    // The stress has the rounding errors of x over the room.
    const double expected = h[0][1][0] / (1 - x / 5);
    EXPECT_NEAR(p[0][1][0], expected, (1e-13 + 1e-14 / room) * expected) << room;
    EXPECT_NEAR(gent->energy(h)[0], -2.5 * std::log1p(-x / 5), 1e-13 + 1e-14 / room);
  }
  for (const double beyond : {1.0 + 1e-12, 1.5, 1e3}) {
    Matrix p;
    EXPECT_LT(gent->stress(sheared(limit * beyond), p)[0], 0);
    EXPECT_LT(gent->admissibility(sheared(limit * beyond))[0], 0);
    EXPECT_TRUE(std::isnan(gent->energy(sheared(limit * beyond))[0]));
  }
  EXPECT_GT(law("Yeoh", 0.3, "Convex")->admissibility(sheared(1e3))[0], 0);
  Matrix inverted{};
  inverted[0][0] = -1.5;
  for (const std::string& name : names) EXPECT_LT(law(name, 0.3, "Convex")->admissibility(inverted)[0], 0) << name;
}

std::string refusal(const std::string& name, const Settings& settings) {
  try {
    make_elastic_law(name, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RubberLawsTest, ConstantsWithoutAPositiveShearModulusAreRefused) {
  EXPECT_EQ(refusal("Mooney-Rivlin", {{"C10", 0.1}, {"C01", -0.1}}),
            "elastic law \"Mooney-Rivlin\": Mooney-Rivlin: C10 0.1 and C01 -0.1: their sum must be greater than 0");
  EXPECT_EQ(
      refusal("Ogden", {{"Moduli", std::vector<double>{1, 2}}}),
      "elastic law \"Ogden\": Ogden: Moduli has 2 numbers and Exponents 1: both need one number for each term, and at "
      "least one");
  EXPECT_EQ(refusal("Ogden", {{"Exponents", std::vector<double>{0}}}),
            "elastic law \"Ogden\": Ogden: Exponents: number 1 is 0; it must not be 0");
  EXPECT_EQ(
      refusal("Ogden", {{"Exponents", std::vector<double>{-2}}}),
      "elastic law \"Ogden\": Ogden: Moduli and Exponents: the shear modulus, half the sum of their products, is -0.6; "
      "it must be greater than 0");
  EXPECT_NE(refusal("Gent", {{"Limit", 0.0}}), "");
  EXPECT_NE(refusal("Yeoh", {{"Poisson's Ratio", 0.5}}), "");
}

}  // namespace
}  // namespace ixos
