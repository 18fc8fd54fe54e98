// Nodal variables of Exodus files, by the file's nodes and by those of the mesh that is read.
#include "io/exodus_values.hpp"

#include "io/exodus_fixture.hpp"
#include "io/exodus_mesh.hpp"
#include "io/exodus_variables.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::expect_contains;

class ExodusValuesTest : public test::ExodusFolderTest {
 protected:
  /// Makes a file with the variables "a" and "strength", whose values at node i (from 0) and time t (from 1) are i + 10
  /// t and 100 times that. Returns its path.
  std::string make(const Mesh& mesh, int times, ExodusFormat format = ExodusFormat::Classic) const {
    ExodusHandle file(create_exodus(path("mesh.e"), format), path("mesh.e"));
    define_exodus_mesh(file, mesh, test::whole(mesh), "title");
    define_variables(file, {{"a", "strength"}, {}, {}}, true);
    for (int t = 1; t <= times; ++t) {
      const double time = 0.5 * t;
      EXPECT_GE(ex_put_time(file, t, &time), 0);
      for (const int factor : {1, 100}) {
        std::vector<double> values;
        for (int node = 0; node < mesh.nodes(); ++node) values.push_back(factor * (node + 10 * t));
        EXPECT_GE(ex_put_var(file, t, EX_NODAL, factor == 1 ? 1 : 2, 1, mesh.nodes(), values.data()), 0);
      }
    }
    EXPECT_EQ(file.close(), 0);
    return path("mesh.e");
  }
};

TEST_F(ExodusValuesTest, ValuesAreThoseOfTheLastTime) {
  for (const ExodusFormat format : {ExodusFormat::Classic, ExodusFormat::Hdf5}) {
    const ExodusHandle file(open(make(test::two_cells(), 3, format)), path("mesh.e"));
    EXPECT_EQ(last_nodal_values(file, "a", 6), (std::vector<double>{30, 31, 32, 33, 34, 35}));
    EXPECT_EQ(last_nodal_values(file, "strength", 6), (std::vector<double>{3000, 3100, 3200, 3300, 3400, 3500}));
  }
}

TEST_F(ExodusValuesTest, UnknownNamesAndFilesWithoutTimesAreRefused) {
  const std::string file = make(test::two_cells(), 0);
  const auto refusal = [&](const std::string& name) { return test::refusal([&] { read_exodus_field(file, name); }); };
  expect_contains(refusal("strenght"), file + ": nodal field \"strenght\" does not exist; did you mean \"strength\"?");
  expect_contains(refusal("strenght"), "The file has");
  expect_contains(refusal("a"), file + ": the nodal field \"a\" has no values: the file has no times");
}

TEST_F(ExodusValuesTest, NodesThatNoCellHasAreLeftOutAsInTheMesh) {
  Mesh mesh = test::two_cells();
  mesh.coordinates.insert(mesh.coordinates.begin() + 4, {7, 7});  // node 2 is in no cell
  for (ElementBlock& block : mesh.blocks)
    for (int& node : block.nodes) node += node >= 2 ? 1 : 0;
  mesh.node_sets.clear();
  const std::string file = make(mesh, 1);
  EXPECT_EQ(read_exodus_mesh(file).coordinates, test::two_cells().coordinates);
  EXPECT_EQ(read_exodus_field(file, "a"), (std::vector<double>{10, 11, 13, 14, 15, 16}));
}

TEST_F(ExodusValuesTest, TruncatedFilesAreRefused) {
  const std::string file = make(test::two_cells(), 2);
  std::filesystem::resize_file(file, 200);
  EXPECT_NE(test::refusal([&] { read_exodus_field(file, "a"); }), "");
  expect_contains(test::refusal([&] { read_exodus_field(path("none.e"), "a"); }), "the mesh file cannot be read");
}

}  // namespace
}  // namespace ixos
