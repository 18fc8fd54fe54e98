// One HDF5 file of all ranks: the same on any number of them, and read as it was written.
#include <gtest/gtest.h>

#include <exodusII.h>

#include "io/hdf5_fields_fixture.hpp"
#include "support/files.hpp"

namespace ixos::test {
namespace {

TEST_F(Hdf5FieldsTest, TheFileIsTheSameOnAnyNumberOfRanks) {
  for (int dimension : {2, 3})
    for (bool enriched : {false, true}) {
      const Mesh mesh = two_blocks(dimension, enriched);
      {
        Writer together(mesh, world(), path("together.e"));
        together.file().create();
        together.write(0, 3);
        EXPECT_EQ(together.file().length().frames, 3);
      }
      write_alone(mesh, "alone.e", 3);
      EXPECT_TRUE(contents(path("together.e")) == contents(path("alone.e"))) << dimension << enriched;
      EXPECT_GT(contents(path("alone.e")).size(), 10000U);
      world()->barrier();
    }
}

// By the Exodus library, which knows nothing of how it was written.
TEST_F(Hdf5FieldsTest, ExodusReadsWhatWasWritten) {
  const Mesh mesh = two_blocks(2, true);
  {
    Writer writer(mesh, world(), path("read.e"));
    writer.file().create();
    writer.write(0, 3);
  }
  if (world()->getRank() != 0) return;
  int word = 8, stored = 0;
  float version = 0;
  const int file = ex_open(path("read.e").c_str(), EX_READ, &word, &stored, &version);
  ASSERT_GE(file, 0);
  ex_init_params header{};
  ASSERT_GE(ex_get_init_ext(file, &header), 0);
  EXPECT_EQ(ex_inquire_int(file, EX_INQ_TIME), 3);
  EXPECT_EQ(header.num_elem, 8 + 2);  // two cells are shown as two each
  EXPECT_EQ(header.num_elem_blk, static_cast<int>(mesh.blocks.size()));
  EXPECT_EQ(header.num_side_sets, static_cast<int>(mesh.side_sets.size()));
  EXPECT_EQ(header.num_node_sets, static_cast<int>(mesh.node_sets.size()));
  const auto nodes = static_cast<std::size_t>(header.num_nodes);
  std::vector<double> x(nodes), y(nodes), values(nodes);
  ex_get_coord(file, x.data(), y.data(), nullptr);
  for (int frame = 0; frame < 3; ++frame) {
    double time = 0, energy = 0;
    ex_get_time(file, frame + 1, &time);
    EXPECT_EQ(time, frame);
    ex_get_var(file, frame + 1, EX_GLOBAL, 1, 0, 1, &energy);
    EXPECT_EQ(energy, 2.0 * frame);
    values.resize(nodes);
    for (int v = 0; v < 3; ++v) {
      ASSERT_GE(ex_get_var(file, frame + 1, EX_NODAL, v + 1, 1, header.num_nodes, values.data()), 0);
      for (std::size_t n = 0; n < nodes; ++n) {
        const double place[2] = {x[n], y[n]};
        EXPECT_NEAR(values[n], nodal_value(place, v, frame), 1e-14);
      }
    }
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
      const bool plain = mesh.blocks[b].type == CellType::Quad4;
      const int cells = mesh.blocks[b].cells(), parts = plain ? 1 : 2;
      values.assign(static_cast<std::size_t>(cells * parts), -1);
      for (int v = 0; v < 2; ++v) {
        ASSERT_GE(
            ex_get_var(file, frame + 1, EX_ELEM_BLOCK, v + 1, static_cast<int>(b) + 1, cells * parts, values.data()),
            0);
        for (int c = 0; c < cells * parts; ++c)
          EXPECT_EQ(values[static_cast<std::size_t>(c)], cell_value(b, c / parts, v, frame));
      }
    }
  }
  ex_close(file);
}

TEST_F(Hdf5FieldsTest, ABlockWithoutCellsHasNoRows) {
  Mesh mesh = two_blocks(3, false);
  mesh.blocks.insert(mesh.blocks.begin(), {"empty", mesh.blocks[0].type, {}});
  for (SideSet& set : mesh.side_sets)
    for (Side& side : set.sides) ++side.block;
  Writer writer(mesh, world(), path("empty.e"));
  writer.file().create();
  writer.write(0, 2);
  writer.file().sync();
  Writer again(mesh, world(), path("empty.e"));
  EXPECT_NO_THROW(again.file().verify({2, 0}));
  again.file().resume({2, 0});
  again.write(2, 3);
  EXPECT_EQ(again.file().length().frames, 3);
}

}  // namespace
}  // namespace ixos::test
