// Variables over time in Exodus files: their names, and which files a restart may continue.
#include "io/exodus_variables.hpp"

#include <array>
#include <fstream>

#include "io/exodus_fixture.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

const FieldNames names{{"u_x", "u_y"}, {"jacobian"}, {"kinetic_energy", "elastic_energy"}};
constexpr ExodusSize size{6, 2};
constexpr int frames = 3;

class ExodusVariablesTest : public test::ExodusFolderTest {
 protected:
  /// Makes a file of the mesh with these names and three frames. Returns its path.
  std::string make(const std::string& name, const Mesh& mesh, bool has_cells,
                   ExodusFormat format = ExodusFormat::Classic) const {
    ExodusHandle file(create_exodus(path(name), format), path(name));
    EXPECT_GE(static_cast<int>(file), 0);
    define_exodus_mesh(file, mesh, test::whole(mesh), "title");
    define_variables(file, names, has_cells);
    for (int frame = 0; frame < frames; ++frame) {
      const double time = 0.5 * frame;
      EXPECT_GE(ex_put_time(file, frame + 1, &time), 0);
    }
    EXPECT_EQ(file.close(), 0);
    return path(name);
  }
  std::string make_two_cells(ExodusFormat format = ExodusFormat::Classic) const {
    return make("fields.e", test::two_cells(), true, format);
  }
};

/// The mesh of a rank that owns no cells.
Mesh nothing() {
  Mesh mesh;
  mesh.blocks = {{"left", CellType::Quad4, {}}};
  return mesh;
}

std::vector<std::string> found_names(const ExodusHandle& file, ex_entity_type type) {
  int count = 0;
  EXPECT_GE(ex_get_variable_param(file, type, &count), 0);
  std::vector<std::string> found;
  for (int i = 1; i <= count; ++i) {
    std::array<char, MAX_STR_LENGTH + 1> text{};
    EXPECT_GE(ex_get_variable_name(file, type, i, text.data()), 0);
    found.emplace_back(text.data());
  }
  return found;
}

std::string refusal(const std::string& path, const ExodusSize& wanted = size, const FieldNames& wanted_names = names,
                    const FieldLength& keep = {frames, 0}, ExodusFormat format = ExodusFormat::Classic) {
  return test::refusal([&] { require_frames(path, format, wanted, wanted_names, keep); });
}

std::string misfit(const std::string& path, int kept = frames) {
  return path + ": cannot resume: the file should have this mesh, these fields and " + std::to_string(kept) +
         " frames. Choose another --output to start new files";
}

TEST_F(ExodusVariablesTest, NamesStandInTheOrderOfTheValues) {
  for (ExodusFormat format : {ExodusFormat::Classic, ExodusFormat::Hdf5}) {
    const ExodusHandle file(open(make_two_cells(format)), "");
    EXPECT_EQ(found_names(file, EX_NODAL), names.nodal);
    EXPECT_EQ(found_names(file, EX_ELEM_BLOCK), names.cell);
    EXPECT_EQ(found_names(file, EX_GLOBAL), names.global);
  }
}

TEST_F(ExodusVariablesTest, AFileWithoutCellsHasGlobalVariablesOnly) {
  const std::string file = make("none.e", nothing(), false);
  {
    const ExodusHandle opened(open(file), "");
    EXPECT_EQ(found_names(opened, EX_NODAL), std::vector<std::string>());
    EXPECT_EQ(found_names(opened, EX_ELEM_BLOCK), std::vector<std::string>());
    EXPECT_EQ(found_names(opened, EX_GLOBAL), names.global);
  }
  EXPECT_EQ(refusal(file, {0, 0}), "");
  EXPECT_EQ(refusal(file, size), misfit(file));
}

TEST_F(ExodusVariablesTest, AFileWithTheFramesToKeepIsAccepted) {
  for (ExodusFormat format : {ExodusFormat::Classic, ExodusFormat::Hdf5}) {
    const std::string file = make_two_cells(format);
    for (int keep = 0; keep <= frames; ++keep) EXPECT_EQ(refusal(file, size, names, {keep, 0}, format), "") << keep;
    EXPECT_EQ(refusal(file, size, names, {frames, bytes_of(file)}, format), "");
  }
}

TEST_F(ExodusVariablesTest, AFileOfAnotherMeshOrLengthIsRefused) {
  const std::string file = make_two_cells();
  EXPECT_EQ(refusal(file, {7, 2}), misfit(file));
  EXPECT_EQ(refusal(file, {6, 3}), misfit(file));
  EXPECT_EQ(refusal(file, size, names, {frames + 1, 0}), misfit(file, frames + 1));
  EXPECT_EQ(refusal(file, size, names, {frames, bytes_of(file) + 1}), misfit(file));
}

TEST_F(ExodusVariablesTest, AFileOfOtherNamesIsRefused) {
  const std::string file = make_two_cells();
  for (auto list : {&FieldNames::nodal, &FieldNames::cell, &FieldNames::global}) {
    FieldNames more = names, fewer = names, renamed = names;
    (more.*list).emplace_back("more");
    (fewer.*list).pop_back();
    (renamed.*list)[0] += "_";
    for (const FieldNames& others : {more, fewer, renamed}) EXPECT_EQ(refusal(file, size, others), misfit(file));
  }
  FieldNames swapped = names;
  std::swap(swapped.nodal[0], swapped.nodal[1]);
  EXPECT_EQ(refusal(file, size, swapped), misfit(file)) << "the order counts";
}

TEST_F(ExodusVariablesTest, AFileOfTheOtherFormatIsRefused) {
  for (const auto& [is, wanted] :
       {std::pair{ExodusFormat::Classic, ExodusFormat::Hdf5}, std::pair{ExodusFormat::Hdf5, ExodusFormat::Classic}}) {
    const std::string file = make_two_cells(is);
    EXPECT_EQ(refusal(file, size, names, {frames, 0}, wanted), misfit(file));
  }
}

TEST_F(ExodusVariablesTest, MissingAndDamagedFilesAreRefused) {
  EXPECT_EQ(refusal(path("none.e")), misfit(path("none.e")));
  EXPECT_EQ(refusal(folder_), misfit(folder_));
  std::ofstream(path("text.e")) << "not a file of Exodus";
  test::expect_contains(refusal(path("text.e")), "cannot resume: frames are missing or damaged");
  const std::string cut = make_two_cells();
  std::filesystem::resize_file(cut, 100);  // within the header
  EXPECT_NE(refusal(cut), "");
}

// Exodus cuts names of more than 32 bytes unless it is told otherwise; names of single interactions may be longer.
TEST_F(ExodusVariablesTest, LongNamesAreComparedAsAWhole) {
  const std::string stem = "pressure_of_an_interaction_with_a_long_name_";
  const FieldNames own{{stem + "a", stem + "b"}, {"jacobian"}, {"kinetic_energy"}};
  for (ExodusFormat format : {ExodusFormat::Classic, ExodusFormat::Hdf5}) {
    {
      ExodusHandle file(create_exodus(path("long.e"), format), path("long.e"));
      define_exodus_mesh(file, test::two_cells(), test::whole(test::two_cells()), "title");
      define_variables(file, own, true);
      EXPECT_EQ(file.close(), 0);
    }
    EXPECT_EQ(refusal(path("long.e"), size, own, {0, 0}, format), "");
    const FieldNames other{{stem + "a", stem + "c"}, own.cell, own.global};
    EXPECT_EQ(refusal(path("long.e"), size, other, {0, 0}, format), misfit(path("long.e"), 0));
  }
}

TEST_F(ExodusVariablesTest, AMissingFileHasNoBytes) {
  std::ofstream(path("five")) << "12345";
  EXPECT_EQ(bytes_of(path("five")), 5);
  EXPECT_EQ(bytes_of(path("none")), 0);
}

}  // namespace
}  // namespace ixos
