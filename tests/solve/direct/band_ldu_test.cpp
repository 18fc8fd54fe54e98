#include "solve/direct/band_ldu.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ixos {
namespace {

using Symmetry = BandLdu::Symmetry;

/// A matrix whose column j reaches down to last[j], and its row j to the right as far.
class Matrix {
 public:
  Matrix(std::vector<int> last, double diagonal, Symmetry symmetry = Symmetry::Symmetric)
      : last_(std::move(last)), symmetry_(symmetry), rows_(last_.size(), std::vector<double>(last_.size())) {
    std::uniform_real_distribution<> between(-1, 1);
    for (int j = 0; j < size(); ++j)
      for (int i = j; i <= last_[static_cast<std::size_t>(j)]; ++i) {
        entry(i, j) = entry(j, i) = between(random_) + (i == j ? diagonal : 0);
        if (symmetry == Symmetry::None && i != j) entry(j, i) = between(random_);
      }
  }

  int size() const { return static_cast<int>(last_.size()); }
  double& entry(int i, int j) { return rows_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]; }
  BandLdu band() const { return BandLdu(last_, symmetry_); }
  void fill(BandLdu& band) {
    band.clear();
    for (int j = 0; j < size(); ++j)
      for (int i = j; i <= last_[static_cast<std::size_t>(j)]; ++i) {
        band.entries()[band.place(i, j)] = entry(i, j);
        if (symmetry_ == Symmetry::None) band.entries()[band.place(j, i)] = entry(j, i);
      }
  }
  /// Returns max |A x - b| / max |b|, where x comes from the factors, for some columns b.
  double error(const BandLdu& band, std::size_t count = 1) {
    std::uniform_real_distribution<> between(-1, 1);
    std::vector<double> b(count * band.padded_size(), 0.0);
    const auto place = [&](std::size_t column, int i) {
      return column * band.padded_size() + static_cast<std::size_t>(i);
    };
    for (std::size_t column = 0; column < count; ++column)
      for (int i = 0; i < size(); ++i) b[place(column, i)] = between(random_);
    std::vector<double> x = b;
    band.solve(x.data(), count);
    double largest = 0;
    for (std::size_t column = 0; column < count; ++column)
      for (int i = 0; i < size(); ++i) {
        double sum = -b[place(column, i)];
        for (int j = 0; j < size(); ++j) sum += entry(i, j) * x[place(column, j)];
        largest = std::max(largest, std::abs(sum));
      }
    return largest;
  }

 private:
  std::vector<int> last_;
  Symmetry symmetry_;
  std::vector<std::vector<double>> rows_;
  std::mt19937 random_;
};

std::vector<int> even(int size, int height) {
  std::vector<int> last;
  for (int j = 0; j < size; ++j) last.push_back(std::min(size - 1, j + height));
  return last;
}

TEST(BandLduTest, SolvesWithBandsOfAnySizeAndHeight) {
  for (const Symmetry symmetry : {Symmetry::Symmetric, Symmetry::None})
    for (int size : {1, 2, 3, 4, 5, 8, 31, 120})
      for (int height : {0, 1, 3, 4, 7, 8, 9, 30, 60}) {
        Matrix matrix(even(size, height), 2.0 * height + 3, symmetry);
        BandLdu band = matrix.band();
        matrix.fill(band);
        ASSERT_TRUE(band.factor()) << size << ' ' << height;
        for (const std::size_t columns : {0, 1, 2, 3, 4, 7})
          EXPECT_LT(matrix.error(band, columns), 1e-14) << size << ' ' << height << ' ' << columns;
        EXPECT_GT(band.pivot_ratio(), 0.1) << size << ' ' << height;
      }
}

TEST(BandLduTest, TheBandWidensAndNarrows) {
  std::vector<int> last{0, 9, 2, 3, 9, 5, 6, 40, 8, 9, 10, 11};
  for (int j = 12; j < 60; ++j) last.push_back(j);
  for (const Symmetry symmetry : {Symmetry::Symmetric, Symmetry::None}) {
    Matrix matrix(last, 20, symmetry);
    BandLdu band = matrix.band();
    matrix.fill(band);
    ASSERT_TRUE(band.factor());
    EXPECT_LT(matrix.error(band), 1e-14);
  }
}

TEST(BandLduTest, IndefiniteMatricesHaveFactorsTooUnlessAPivotVanishes) {
  Matrix matrix(even(50, 6), 0);
  for (int j = 0; j < 50; ++j) matrix.entry(j, j) = j % 2 == 0 ? 9 : -9;
  BandLdu band = matrix.band();
  matrix.fill(band);
  ASSERT_TRUE(band.factor());
  EXPECT_LT(matrix.error(band), 1e-13);

  Matrix swap(even(2, 1), 0);  // the matrix that swaps two numbers
  swap.entry(0, 0) = swap.entry(1, 1) = 0;
  BandLdu two = swap.band();
  swap.fill(two);
  EXPECT_FALSE(two.factor());
}

TEST(BandLduTest, ThePivotRatioIsThatOfTheFactors) {
  // L D U = (1 0; 2 1) diag(3, 6) (1 5; 0 1)
  Matrix matrix(even(2, 1), 0, Symmetry::None);
  matrix.entry(0, 0) = 3;
  matrix.entry(1, 0) = 6;
  matrix.entry(0, 1) = 15;
  matrix.entry(1, 1) = 36;
  BandLdu band = matrix.band();
  matrix.fill(band);
  ASSERT_TRUE(band.factor());
  EXPECT_DOUBLE_EQ(band.pivot_ratio(), 0.5);
  EXPECT_DOUBLE_EQ(band.entries()[band.place(1, 0)], 2);
  EXPECT_DOUBLE_EQ(band.entries()[band.place(0, 1)], 5);
}

TEST(BandLduTest, ANumberThatIsNotFiniteIsFound) {
  Matrix matrix(even(30, 4), 12);
  BandLdu band = matrix.band();
  for (const auto& [i, j] : {std::pair{0, 0}, {29, 29}, {17, 14}}) {
    matrix.fill(band);
    band.entries()[band.place(i, j)] = std::nan("");
    EXPECT_FALSE(band.factor()) << i << ' ' << j;
  }
  matrix.fill(band);
  EXPECT_TRUE(band.factor()) << "nothing of the failures stays";
  EXPECT_LT(matrix.error(band), 1e-14);
}

TEST(BandLduTest, OperationsGrowWithTheSquareOfTheHeight) {
  // Each of n columns with h entries below takes h^2 multiplications and additions, to the order of h.
  EXPECT_NEAR(BandLdu::operations(even(4000, 96)), 4000.0 * 96 * 96, 0.1 * 4000 * 96 * 96);
}

}  // namespace
}  // namespace ixos
