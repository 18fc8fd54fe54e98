// Checkpoint files: what is written comes back, on every number of ranks.
#include "checkpoint/checkpoint_file.hpp"

#include <gtest/gtest.h>

#include <Tpetra_Map.hpp>
#include <cmath>
#include <filesystem>

#include "checkpoint/seal.hpp"
#include "mesh/fingerprint.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

/// What an object may keep.
struct Memory {
  bool flag = true;
  int count = -7;
  long steps = 123456789012;
  double third = 1.0 / 3, none = std::nan("");
  std::string text = "a \"text\"\nof two lines";
  std::vector<double> field, owned, absent, share;

  void transfer(Record& record) {
    const Record::Section outer(record, "outer");
    record.number("flag", flag);
    record.number("count", count);
    {
      const Record::Section inner(record, "inner 1");
      record.number("steps", steps);
      record.field("field", field, Extent::Local);
    }
    record.number("third", third);
    record.number("none", none);
    record.text("text", text);
    record.field("owned", owned, Extent::Owned);
    record.field("absent", absent, Extent::Local);
    record.share("share", share);
  }
};

class CheckpointFileTest : public testing::Test {
 protected:
  CheckpointFileTest() {
    BoxShape shape;
    shape.dimension = 2;
    shape.divisions = {5, 3, 1};
    mesh_ = box(shape);
    const int ranks = world()->getSize();
    local_ = localize(mesh_, partition_nodes(mesh_, ranks), world()->getRank(), ranks);
    space_ = std::make_unique<DofSpace>(local_, world());
    // Values that tell where they belong.
    for (int id : local_.original_ids)
      for (int d = 0; d < 2; ++d) memory_.field.push_back(std::sqrt(2.0 + 2 * id + d));
    memory_.owned.assign(memory_.field.begin(), memory_.field.begin() + space_->owned());
    // Of different length on each rank, empty on the last of several.
    if (world()->getRank() + 1 < ranks || ranks == 1) memory_.share = {1.0 + world()->getRank(), 0.1, 1e300};
  }
  void TearDown() override {
    world()->barrier();
    if (world()->getRank() == 0) std::filesystem::remove(path_);
  }
  void write() {
    CheckpointSize size;
    memory_.transfer(size);
    CheckpointWriter writer(path_, *space_, local_, size.bytes());
    memory_.transfer(writer);
    writer.publish();
    if (world()->getRank() == 0) {
      EXPECT_LE(static_cast<double>(std::filesystem::file_size(path_)), size.bytes() * world()->getSize());
    }
  }

  Mesh mesh_;
  LocalMesh local_;
  std::unique_ptr<DofSpace> space_;
  Memory memory_;
  std::string path_ = testing::TempDir() + "checkpoint.h5";
};

TEST_F(CheckpointFileTest, WhatIsWrittenComesBack) {
  write();
  EXPECT_EQ(seal_problem(path_), "");
  EXPECT_FALSE(std::filesystem::exists(path_ + ".tmp"));
  CheckpointReader reader(path_, *space_, local_);
  EXPECT_TRUE(reader.exact());
  EXPECT_EQ(reader.ranks(), world()->getSize());
  Memory back;
  back.flag = false;
  back.absent = {1, 2};
  back.transfer(reader);
  EXPECT_EQ(back.flag, true);
  EXPECT_EQ(back.count, -7);
  EXPECT_EQ(back.steps, 123456789012);
  EXPECT_EQ(back.third, 1.0 / 3);
  EXPECT_TRUE(std::isnan(back.none));
  EXPECT_EQ(back.text, memory_.text);
  EXPECT_EQ(back.field, memory_.field) << "ghosts too";
  EXPECT_EQ(back.owned, memory_.owned);
  EXPECT_TRUE(back.absent.empty());
  EXPECT_EQ(back.share, memory_.share);
}

TEST_F(CheckpointFileTest, AnotherPartitionFindsItsNodesByNumber) {
  write();
  // All ranks but the first own nothing: the partition of a single rank.
  const LocalMesh other = localize(mesh_, std::vector<int>(static_cast<std::size_t>(mesh_.nodes()), 0),
                                   world()->getRank(), world()->getSize());
  const DofSpace space(other, world());
  CheckpointReader reader(path_, space, other);
  EXPECT_EQ(reader.exact(), world()->getSize() == 1);
  reader.set_same(true, true);
  const Record::Section outer(reader, "outer");
  const Record::Section inner(reader, "inner 1");
  std::vector<double> field;
  reader.field("field", field, Extent::Local);
  ASSERT_EQ(field.size(), static_cast<std::size_t>(space.local()));
  for (std::size_t node = 0; node < other.original_ids.size(); ++node)
    for (std::size_t d = 0; d < 2; ++d)
      EXPECT_EQ(field[2 * node + d], std::sqrt(2.0 + 2 * other.original_ids[node] + static_cast<double>(d)));
}

TEST_F(CheckpointFileTest, NumbersOutOfRangeAreRefused) {
  memory_.third = 0.5;
  memory_.none = -3;
  memory_.field.front() = std::nan("");  // owned, on every rank
  write();
  CheckpointReader reader(path_, *space_, local_);
  const Record::Section outer(reader, "outer");
  int whole = 0;
  std::size_t count = 0;
  EXPECT_THROW(reader.number("third", whole), InputError);
  EXPECT_THROW(reader.number("none", count), InputError);
  reader.number("none", whole);
  EXPECT_EQ(whole, -3);
  const Record::Section inner(reader, "inner 1");
  std::vector<double> field;
  EXPECT_THROW(reader.field("field", field, Extent::Local), InputError) << "a NaN is no state";
}

TEST_F(CheckpointFileTest, WhatIsMissingOrDoesNotFitIsRefusedByName) {
  write();
  CheckpointReader reader(path_, *space_, local_);
  double value = 0;
  int whole = 0;
  std::vector<double> field;
  EXPECT_THROW(reader.number("nothing", value), InputError);
  const Record::Section outer(reader, "outer");
  EXPECT_THROW(reader.number("none", whole), InputError) << "a NaN is no whole number";
  EXPECT_THROW(reader.field("share", field, Extent::Local), InputError) << "not one value a degree of freedom";
  try {
    reader.number("nothing", value);
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("\"nothing\""), std::string::npos) << error.what();
  }
}

TEST_F(CheckpointFileTest, AFolderThatIsNotThereIsAFileErrorOnAllRanks) {
  EXPECT_THROW(CheckpointWriter("/nowhere/checkpoint.h5", *space_, local_, 0), FileError);
}

TEST_F(CheckpointFileTest, AFullDiskIsAFileErrorOnAllRanksAndLeavesTheOldOne) {
  write();
  EXPECT_THROW(CheckpointWriter(path_, *space_, local_, 1e17), FileError) << "more than any disk has";
  EXPECT_EQ(seal_problem(path_), "");
}

TEST(FingerprintTest, MeshesDifferByAnyOfTheirParts) {
  BoxShape shape;
  shape.dimension = 2;
  shape.divisions = {2, 2, 1};
  const Mesh mesh = box(shape);
  EXPECT_EQ(fingerprint(mesh), fingerprint(box(shape)));
  EXPECT_EQ(fingerprint(mesh).size(), 32U);
  const auto differs = [&](const auto& change) {
    Mesh other = mesh;
    change(other);
    return fingerprint(other) != fingerprint(mesh);
  };
  EXPECT_TRUE(differs([](Mesh& m) { m.coordinates[3] = std::nextafter(m.coordinates[3], 2); }));
  EXPECT_TRUE(differs([](Mesh& m) { std::swap(m.blocks[0].nodes[0], m.blocks[0].nodes[1]); }));
  EXPECT_TRUE(differs([](Mesh& m) { m.blocks[0].name += "x"; }));
  EXPECT_FALSE(differs([](Mesh& m) { m.side_sets.pop_back(); })) << "sets may come and go";
}

}  // namespace
}  // namespace ixos
