// The states of a program around Ixos in a checkpoint file.
#include "checkpoint/program_state.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "checkpoint/checkpoint_file.hpp"
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
    const Mesh mesh = box(shape);
    const int ranks = world()->getSize();
    local_ = localize(mesh, partition_nodes(mesh, ranks), world()->getRank(), ranks);
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

TEST_F(ProgramStateTest, NamesThatAreNotAllowed) {
  Stage platen;
  for (const char* name : {"", "a/b", "a\nb"}) EXPECT_THROW(write({platen.state(name)}), std::logic_error) << name;
  EXPECT_THROW(write({platen.state("a"), platen.state("a")}), std::logic_error);
}

}  // namespace
}  // namespace ixos
