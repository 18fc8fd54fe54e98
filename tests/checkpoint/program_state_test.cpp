// The states of a program around Ixos in a checkpoint file.
#include "checkpoint/program_state.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "checkpoint/checkpoint_file.hpp"
#include "io/disk_file.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::refusal;
using test::world;

/// A stage with a share of numbers on each rank.
struct Stage {
  double place = 0.25;
  std::vector<double> forces = std::vector<double>(static_cast<std::size_t>(world()->getRank() + 2), 1.0 / 3);

  ProgramState state(const std::string& name) {
    return {name, [this](Record& record) {
              record.number("place", place);
              record.array("forces", forces);
            }};
  }
};

class ProgramStateTest : public testing::Test {
 protected:
  ProgramStateTest() {
    BoxShape shape;
    shape.dimension = 2;
    shape.divisions = {3, 2, 1};
    mesh_ = box(shape);
    const int ranks = world()->getSize();
    local_ = localize(mesh_, partition_nodes(mesh_, ranks), world()->getRank(), ranks);
    space_ = std::make_unique<DofSpace>(local_, world());
  }
  void TearDown() override {
    world()->barrier();
    if (world()->getRank() == 0) std::filesystem::remove(path_);
  }
  void write(const std::vector<ProgramState>& states) const {
    write_checkpoint_file(path_, *space_, local_, [&](Record& record) { transfer(record, states); });
  }
  void read(const std::vector<ProgramState>& states) const {
    CheckpointReader reader(path_, *space_, local_);
    transfer(reader, states);
  }

  Mesh mesh_;
  LocalMesh local_;
  std::unique_ptr<DofSpace> space_;
  std::string path_ = testing::TempDir() + "program_state.h5";
};

TEST_F(ProgramStateTest, StatesComeBack) {
  Stage platen, lid;
  lid.place = 7;
  write({platen.state("platen"), lid.state("lid")});
  platen.place = lid.place = 0;
  platen.forces.assign(platen.forces.size(), 0.0);
  read({lid.state("lid"), platen.state("platen")});  // in any order
  EXPECT_EQ(platen.place, 0.25);
  EXPECT_EQ(lid.place, 7);
  EXPECT_EQ(platen.forces, Stage().forces);
}

TEST_F(ProgramStateTest, StatesThatAreMissingOrUnreadAreRefused) {
  Stage platen, lid;
  write({platen.state("platen")});
  expect_contains(refusal([&] {
                    read({platen.state("platen"), lid.state("lid")});
                  }),
                  "lacks \"lid\", the state of this program; it has \"platen\"");
  expect_contains(refusal([&] { read({}); }), "holds \"platen\", the state of a program around Ixos");
  write({});
  expect_contains(refusal([&] { read({platen.state("platen")}); }), "no program's state is in it");
  read({});
}

TEST_F(ProgramStateTest, AStateOfAnotherShapeIsRefused) {
  Stage platen;
  write({platen.state("platen")});
  if (world()->getRank() == 0) platen.forces.resize(5);  // the other ranks' shares fit
  expect_contains(refusal([&] { read({platen.state("platen")}); }),
                  "\"platen\", a state of this program: \"forces\" has 2 values on rank 0, not 5");
  double other = 0;
  const ProgramState more{"platen", [&](Record& record) { record.number("speed", other); }};
  expect_contains(refusal([&] { read({more}); }), "\"speed\"");
}

/// Values that tell where they belong: by the number of the node in the mesh.
std::vector<double> field_of(const LocalMesh& mesh) {
  std::vector<double> field;
  for (const auto id : mesh.original_ids)
    for (int i = 0; i < 2; ++i) field.push_back(0.5 + 2 * static_cast<double>(id) + i);
  return field;
}

/// The state of a solver whose number of ranks may change.
struct Solver {
  double time = 0.75;
  std::vector<double> field, share;

  ProgramState state() {
    return {"solver", [this](Record& record) {
              record.number("time", time);
              record.field("field", field, Extent::Local);
              if (record.loading())
                record.all_shares("share", share);
              else
                record.share("share", share);
            }};
  }
};

TEST_F(ProgramStateTest, AnotherNumberOfRanksReadsNumbersFieldsAndAllShares) {
  // One rank writes, all read; all write, and each reads the whole.
  const LocalMesh whole = localize(mesh_, partition_nodes(mesh_, 1), 0, 1);
  const DofSpace alone(whole, test::self());
  const int ranks = world()->getSize();
  for (const bool one_writes : {true, false}) {
    Solver written{0.75, field_of(one_writes ? whole : local_), {}}, read{0, {}, {}};
    const double first = one_writes ? 0 : 10.0 * world()->getRank();
    for (int i = 0; i < 3; ++i) written.share.push_back(first + i);
    Stage stage;
    const auto name = [&](Record& record) { transfer(record, {written.state(), stage.state("stage")}); };
    if (!one_writes) write_checkpoint_file(path_, *space_, local_, name);
    if (one_writes && world()->getRank() == 0) write_checkpoint_file(path_, alone, whole, name);
    world()->barrier();
    const LocalMesh& here = one_writes ? local_ : whole;
    CheckpointReader reader(path_, one_writes ? *space_ : alone, here);
    EXPECT_EQ(reader.ranks(), one_writes ? 1 : ranks);
    double place = 0;
    transfer(reader, {read.state(), {"stage", [&](Record& record) { record.number("place", place); }}});
    EXPECT_EQ(read.time, 0.75);
    EXPECT_EQ(read.field, field_of(here));
    EXPECT_EQ(place, 0.25);
    std::vector<double> shares;
    for (int rank = 0; rank < (one_writes ? 1 : ranks); ++rank)
      for (int i = 0; i < 3; ++i) shares.push_back(10.0 * rank + i);
    EXPECT_EQ(read.share, shares);
    const std::string message = refusal([&] { transfer(reader, {read.state(), stage.state("stage")}); });
    if (ranks == 1)
      EXPECT_EQ(message, "");
    else
      expect_contains(message, "\"forces\" was written by " + std::to_string(one_writes ? 1 : ranks) + " rank(s)");
    world()->barrier();
  }
}

TEST_F(ProgramStateTest, AStateThatFailsLeavesTheEarlierFileAlone) {
  Stage platen;
  write({platen.state("platen")});
  int calls = 0;
  const ProgramState failing{"platen", [&](Record& record) {
                               record.number("place", platen.place);
                               if (++calls == 2) throw InputError("the platen is lost");
                             }};
  expect_contains(refusal([&] { write({failing}); }), "the platen is lost");
  EXPECT_EQ(calls, 2);  // once to learn the size
  world()->barrier();
  EXPECT_FALSE(std::filesystem::exists(beside(path_)));
  platen.place = 0;
  read({platen.state("platen")});
  EXPECT_EQ(platen.place, 0.25);
}

TEST_F(ProgramStateTest, NamesThatAreNotAllowed) {
  Stage platen;
  for (const char* name : {"", "a/b", "a\nb"}) EXPECT_THROW(write({platen.state(name)}), std::logic_error) << name;
  EXPECT_THROW(write({platen.state("a"), platen.state("a")}), std::logic_error);
}

}  // namespace
}  // namespace ixos
