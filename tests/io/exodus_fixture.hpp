/// A small mesh for the tests of Exodus files, and what the library itself reads of them.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>
#include <string>

#include "base/error.hpp"
#include "io/exodus_definition.hpp"
#include "support/refusal.hpp"

namespace ixos::test {

/// Two quadrilaterals side by side, each in its block; a block and a node set without members.
inline Mesh two_cells() {
  Mesh mesh;
  mesh.coordinates = {0, 0, 1, 0, 2.5, 0, 0, 1, 1, 1, 2.5, 1};
  mesh.blocks = {{"left", CellType::Quad4, {0, 1, 4, 3}},
                 {"right", CellType::Quad4, {1, 2, 5, 4}},
                 {"empty", CellType::Quad4, {}}};
  mesh.node_sets = {{"ends", {0, 5}}, {"none", {}}};
  mesh.side_sets = {{"top", {{0, 0, 2}, {1, 0, 2}}}};
  return mesh;
}

/// Returns the description of a mesh that is whole.
inline ExodusShare whole(const Mesh& mesh) {
  ExodusShare share;
  share.node_ids.resize(static_cast<std::size_t>(mesh.nodes()));
  share.cell_ids.resize(static_cast<std::size_t>(mesh.cells()));
  std::iota(share.node_ids.begin(), share.node_ids.end(), 1);
  std::iota(share.cell_ids.begin(), share.cell_ids.end(), 1);
  return share;
}

/// A folder for the files of a test.
class ExodusFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  /// Opens a file to read.
  static int open(const std::string& path) {
    int word = 8, stored = 0;
    float version = 0;
    return ex_open(path.c_str(), EX_READ, &word, &stored, &version);
  }

  std::string folder_ = testing::TempDir() + "exodus_folder";
};

}  // namespace ixos::test
