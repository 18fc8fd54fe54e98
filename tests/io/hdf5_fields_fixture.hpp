/// A body of two blocks, and files of its fields that the ranks write together.
#pragma once
#include <gtest/gtest.h>

#include <Teuchos_DefaultMpiComm.hpp>

#include "base/agreement.hpp"
#include "io/field_file.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "mesh/selection.hpp"
#include "support/scene_text.hpp"

namespace ixos::test {

inline const FieldNames names{{"displacement_x", "displacement_y", "weight"}, {"stress", "mark"}, {"energy"}};

/// Two blocks; where it is enriched, in both directions of its contact faces, then more.
inline Mesh two_blocks(int dimension, bool enriched) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {4, 2, 2};
  shape.divisions = {4, 2, 2};
  Mesh mesh = box(shape);
  const auto n = static_cast<std::size_t>(nodes_per_cell(mesh.blocks[0].type));
  ElementBlock second = mesh.blocks[0];
  second.name = "second";
  const auto cut = mesh.blocks[0].nodes.begin() + static_cast<std::ptrdiff_t>(5 * n);
  second.nodes.assign(cut, mesh.blocks[0].nodes.end());
  mesh.blocks[0].nodes.erase(cut, mesh.blocks[0].nodes.end());
  for (SideSet& set : mesh.side_sets)
    for (Side& side : set.sides)
      if (side.cell >= 5) side = {1, side.cell - 5, side.side};
  mesh.blocks.push_back(second);
  if (enriched) {
    add_side_set(mesh, "patch", "bottom", {{}, std::vector<double>(static_cast<std::size_t>(dimension), 2.0)});
    enrich(mesh, "patch", ContactElement::Q1C2);
  }
  return mesh;
}

inline double nodal_value(const double* x, int variable, double time) {
  return (variable + 1) * x[0] - 2 * x[1] + variable * time;
}
inline double cell_value(std::size_t block, int cell, int variable, double time) {
  return 100.0 * static_cast<double>(block) + cell + 0.25 * variable + time;
}

/// A file of a mesh by the ranks of `comm`, with frames at the times 0, 1, 2, ...
class Writer {
 public:
  Writer(const Mesh& mesh, const Comm& comm, const std::string& path) : mesh_(share(mesh, comm)) {
    file_ = hdf5_fields(path, {OutputMesh(mesh_, comm->getSize()), names, "test"}, comm);
  }
  FieldFile& file() { return *file_; }

  void write(int first, int end) {
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    for (int frame = first; frame < end; ++frame) {
      std::vector<std::vector<double>> nodal(3);
      std::vector<std::vector<std::vector<double>>> cell(2);
      for (int v = 0; v < 3; ++v)
        for (std::size_t node = 0; node < static_cast<std::size_t>(mesh_.nodes()); ++node)
          nodal[static_cast<std::size_t>(v)].push_back(nodal_value(&mesh_.coordinates[node * d], v, frame));
      for (int v = 0; v < 2; ++v)
        for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
          cell[static_cast<std::size_t>(v)].emplace_back();
          for (int id : mesh_.blocks[b].original_cells)
            cell[static_cast<std::size_t>(v)].back().push_back(cell_value(b, id, v, frame));
        }
      file_->write(frame, nodal, cell, {2.0 * frame});
    }
  }

 private:
  static LocalMesh share(const Mesh& mesh, const Comm& comm) {
    return localize(mesh, partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize());
  }
  LocalMesh mesh_;
  std::unique_ptr<FieldFile> file_;
};

inline Comm alone() {
  return Teuchos::rcp(new Teuchos::MpiComm<int>(Teuchos::opaqueWrapper(static_cast<MPI_Comm>(MPI_COMM_SELF))));
}

class Hdf5FieldsTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return testing::TempDir() + name; }
  /// A file of the first rank alone.
  void write_alone(const Mesh& mesh, const std::string& name, int frames) {
    on_first_rank(world(), [&] {
      Writer writer(mesh, alone(), path(name));
      writer.file().create();
      writer.write(0, frames);
    });
  }
};

/// For tests of one rank.
class Hdf5FieldsSerialTest : public Hdf5FieldsTest {
 protected:
  void SetUp() override {
    if (world()->getSize() > 1) GTEST_SKIP() << "one rank tests this";
  }
};

}  // namespace ixos::test
