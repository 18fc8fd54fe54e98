// Numbers at quadrature points in checkpoints: of the same partition, and of another one.
#include "state/point_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "checkpoint/checkpoint_file.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

constexpr std::size_t points = 4, numbers = 3;
constexpr auto width = static_cast<std::size_t>(pack_width);

/// A box's part on one of the ranks of a communicator.
struct Part {
  explicit Part(const Comm& comm, int columns = 7) {
    BoxShape shape;
    shape.divisions = {columns, 3, 1};
    shape.dimension = 2;
    const Mesh mesh = box(shape);
    local = localize(mesh, partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize());
    space = std::make_unique<DofSpace>(local, comm);
  }
  const LocalBlock& block() const { return local.blocks.front(); }
  LocalMesh local;
  std::unique_ptr<DofSpace> space;
};

/// A number that tells its cell in the mesh, point and place.
double number(int cell, std::size_t point, std::size_t place) {
  return std::sqrt(2.0 + 100 * cell + 10 * static_cast<double>(point) + static_cast<double>(place));
}

template <class Visit>
void for_each_number(const LocalBlock& block, const Visit& visit) {
  for (std::size_t cell = 0; cell < block.original_cells.size(); ++cell)
    for (std::size_t q = 0; q < points; ++q)
      for (std::size_t k = 0; k < numbers; ++k)
        visit(cell / width, cell % width, q, k, number(block.original_cells[cell], q, k));
}

PointData filled(const LocalBlock& block) {
  PointData data(block, points, numbers);
  for_each_number(block, [&](std::size_t batch, std::size_t lane, std::size_t q, std::size_t k, double value) {
    data(batch, q, k)[lane] = value;
  });
  return data;
}

void expect_filled(const LocalBlock& block, const PointData& data) {
  for_each_number(block, [&](std::size_t batch, std::size_t lane, std::size_t q, std::size_t k, double value) {
    EXPECT_EQ(double(data(batch, q, k)[lane]), value) << batch << " " << lane << " " << q << " " << k;
  });
}

class PointDataTest : public testing::Test {
 protected:
  void TearDown() override {
    test::world()->barrier();
    if (test::world()->getRank() == 0) std::filesystem::remove(path_);
  }
  /// Writes the numbers of all ranks' cells.
  void write(const Part& part) {
    PointData data = filled(part.block());
    CheckpointSize size;
    data.transfer(size);
    CheckpointWriter writer(path_, *part.space, part.local, size.bytes());
    data.transfer(writer);
    writer.publish();
    test::world()->barrier();
  }
  std::string path_ = testing::TempDir() + "point_data.h5";
};

TEST_F(PointDataTest, StartsAtZeroAndClears) {
  const Part part(test::self());
  PointData data(part.block(), points, numbers);
  EXPECT_EQ(double(data(0, 0)[0]), 0);
  data = filled(part.block());
  EXPECT_NE(double(data(0, 3, 2)[0]), 0);
  data.clear();
  EXPECT_EQ(double(data(0, 3, 2)[0]), 0);
}

TEST_F(PointDataTest, ComesBackOnTheSamePartition) {
  const Part part(test::world());
  write(part);
  CheckpointReader reader(path_, *part.space, part.local);
  PointData back(part.block(), points, numbers);
  back.transfer(reader);
  expect_filled(part.block(), back);
}

TEST_F(PointDataTest, ComesBackOnAnotherPartition) {
  write(Part(test::world()));
  const Part alone(test::self());
  CheckpointReader reader(path_, *alone.space, alone.local);
  PointData back(alone.block(), points, numbers);
  back.transfer(reader);
  expect_filled(alone.block(), back);
}

/// The sides of a part's set, and numbers that tell them from others.
struct SidesOfPart {
  explicit SidesOfPart(const LocalMesh& mesh)
      : sides(mesh.side_sets[mesh.side_set("bottom")]), data(mesh, sides, 2, 1) {
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t q = 0; q < 2; ++q)
        expected.push_back(number(mesh.blocks.front().original_cells[static_cast<std::size_t>(sides[i].cell)], q, 0));
  }
  void fill() {
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t q = 0; q < 2; ++q) data(i / width, q)[i % width] = expected[2 * i + q];
  }
  void expect_filled() const {
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t q = 0; q < 2; ++q) EXPECT_EQ(double(data(i / width, q)[i % width]), expected[2 * i + q]) << i;
  }
  const std::vector<LocalSide>& sides;
  PointData data;
  std::vector<double> expected;
};

TEST_F(PointDataTest, NumbersOfSidesComeBackOnAnyPartition) {
  const Part part(test::world());
  SidesOfPart written(part.local);
  written.fill();
  CheckpointSize size;
  written.data.transfer(size);
  CheckpointWriter writer(path_, *part.space, part.local, size.bytes());
  written.data.transfer(writer);
  writer.publish();
  test::world()->barrier();
  CheckpointReader reader(path_, *part.space, part.local);
  SidesOfPart back(part.local);
  back.data.transfer(reader);
  back.expect_filled();
  const Part alone(test::self());
  CheckpointReader other(path_, *alone.space, alone.local);
  SidesOfPart whole(alone.local);
  ASSERT_EQ(whole.sides.size(), 7U);
  whole.data.transfer(other);
  whole.expect_filled();
}

TEST_F(PointDataTest, AnotherNumberOfPointsIsRefused) {
  const Part part(test::world());
  write(part);
  CheckpointReader reader(path_, *part.space, part.local);
  PointData other(part.block(), points + 1, numbers);
  EXPECT_THROW(other.transfer(reader), InputError);
}

}  // namespace
}  // namespace ixos
