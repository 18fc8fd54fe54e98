#include "solve/band_ldl.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ixos {
namespace {

/// A symmetric matrix whose column j reaches down to last[j].
class Matrix {
 public:
  Matrix(std::vector<int> last, double diagonal) : last_(std::move(last)), rows_(last_.size()) {
    std::uniform_real_distribution<> between(-1, 1);
    for (int j = 0; j < size(); ++j) {
      rows_[static_cast<std::size_t>(j)].resize(last_.size());
      for (int i = j; i <= last_[static_cast<std::size_t>(j)]; ++i)
        lower(i, j) = between(random_) + (i == j ? diagonal : 0);
    }
  }

  int size() const { return static_cast<int>(last_.size()); }
  double& lower(int i, int j) { return rows_[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)]; }
  void fill(BandLdl& band) {
    band.clear();
    for (int j = 0; j < size(); ++j)
      for (int i = j; i <= last_[static_cast<std::size_t>(j)]; ++i) band.entries()[band.place(i, j)] = lower(i, j);
  }
  /// Returns max |A x - b| / max |b|, where x comes from the factors.
  double error(const BandLdl& band) {
    std::uniform_real_distribution<> between(-1, 1);
    std::vector<double> b(band.padded_size(), 0.0);
    for (int i = 0; i < size(); ++i) b[static_cast<std::size_t>(i)] = between(random_);
    std::vector<double> x = b;
    band.solve(x.data());
    double largest = 0;
    for (int i = 0; i < size(); ++i) {
      double sum = -b[static_cast<std::size_t>(i)];
      for (int j = 0; j < size(); ++j) sum += lower(std::max(i, j), std::min(i, j)) * x[static_cast<std::size_t>(j)];
      largest = std::max(largest, std::abs(sum));
    }
    return largest;
  }

 private:
  std::vector<int> last_;
  std::vector<std::vector<double>> rows_;
  std::mt19937 random_;
};

std::vector<int> even(int size, int height) {
  std::vector<int> last;
  for (int j = 0; j < size; ++j) last.push_back(std::min(size - 1, j + height));
  return last;
}

TEST(BandLdlTest, SolvesWithBandsOfAnySizeAndHeight) {
  for (int size : {1, 2, 3, 4, 5, 8, 31, 120})
    for (int height : {0, 1, 3, 4, 7, 8, 9, 30}) {
      Matrix matrix(even(size, height), 2.0 * height + 3);
      BandLdl band(even(size, height));
      matrix.fill(band);
      ASSERT_TRUE(band.factor()) << size << ' ' << height;
      EXPECT_LT(matrix.error(band), 1e-14) << size << ' ' << height;
    }
}

TEST(BandLdlTest, TheBandWidensAndNarrows) {
  std::vector<int> last{0, 9, 2, 3, 9, 5, 6, 40, 8, 9, 10, 11};
  for (int j = 12; j < 60; ++j) last.push_back(j);
  Matrix matrix(last, 20);
  BandLdl band(last);
  matrix.fill(band);
  ASSERT_TRUE(band.factor());
  EXPECT_LT(matrix.error(band), 1e-14);
}

TEST(BandLdlTest, IndefiniteMatricesHaveFactorsTooUnlessAPivotVanishes) {
  Matrix matrix(even(50, 6), 0);
  for (int j = 0; j < 50; ++j) matrix.lower(j, j) = j % 2 == 0 ? 9 : -9;
  BandLdl band(even(50, 6));
  matrix.fill(band);
  ASSERT_TRUE(band.factor());
  EXPECT_LT(matrix.error(band), 1e-13);

  Matrix swap(even(2, 1), 0);  // the matrix that swaps two numbers
  swap.lower(0, 0) = swap.lower(1, 1) = 0;
  BandLdl two(even(2, 1));
  swap.fill(two);
  EXPECT_FALSE(two.factor());
}

TEST(BandLdlTest, ANumberThatIsNotFiniteIsFound) {
  Matrix matrix(even(30, 4), 12);
  BandLdl band(even(30, 4));
  for (const auto& [i, j] : {std::pair{0, 0}, {29, 29}, {17, 14}}) {
    matrix.fill(band);
    band.entries()[band.place(i, j)] = std::nan("");
    EXPECT_FALSE(band.factor()) << i << ' ' << j;
  }
  matrix.fill(band);
  EXPECT_TRUE(band.factor()) << "nothing of the failures stays";
  EXPECT_LT(matrix.error(band), 1e-14);
}

TEST(BandLdlTest, OperationsGrowWithTheSquareOfTheHeight) {
  // Each of n columns with h entries below takes h^2 multiplications and additions, to the order of h.
  EXPECT_NEAR(BandLdl::operations(even(4000, 96)), 4000.0 * 96 * 96, 0.1 * 4000 * 96 * 96);
}

}  // namespace
}  // namespace ixos
