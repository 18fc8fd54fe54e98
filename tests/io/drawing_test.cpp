// Drawings that gmsh makes meshes of.
#include "io/drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "io/geo_script.hpp"
#include "io/gmsh_mesh.hpp"
#include "support/mesh_points.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::refusal;

/// A folder, which is also the cache.
class DrawingTest : public testing::Test {
 protected:
  DrawingTest() { setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1); }
  ~DrawingTest() override { unsetenv("IXOS_TRUST_GEOMETRY"); }

  std::string written(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() + "/" + name) << text;
    return folder_.path() + "/" + name;
  }
  std::string refused(const std::string& text) const {
    return refusal([&] { drawing_files(written("script.geo", text), false); });
  }

  test::TemporaryFolder folder_;
};

/// Tests that need the program.
class GmshTest : public DrawingTest {
 protected:
  void SetUp() override {
    if (std::system("gmsh --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "gmsh is not installed";
  }
  /// A quarter of a ring between the radii 1 and `radius`, 2 unless a constant says otherwise.
  std::string ring(const std::string& more = "") const {
    return written("ring.geo",
                   "DefineConstant[ radius = 2 ];\n"
                   "Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {radius, 0, 0};\n"
                   "Point(4) = {0, radius, 0}; Point(5) = {0, 1, 0};\n"
                   "Line(1) = {2, 3}; Circle(2) = {3, 1, 4}; Line(3) = {4, 5}; Circle(4) = {5, 1, 2};\n"
                   "Curve Loop(1) = {1:4}; Plane Surface(1) = {1};\n"
                   "Physical Surface(\"ring\") = {1}; Physical Curve(\"hole\") = {4};\n" +
                       more);
  }
  std::string block() const {
    return written(
        "block.geo",
        "SetFactory(\"OpenCASCADE\"); Box(1) = {0, 0, 0, 4, 2, 1};\n"
        "Cylinder(2) = {2, 1, -1, 0, 0, 3, 0.5}; BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n");
  }
  static Mesh mesh_of(const std::string& path, const DrawingOptions& options) {
    return read_gmsh_mesh(drawn_mesh(path, options).path);
  }
  static DrawingOptions sized(double size) {
    DrawingOptions options;
    options.size = size;
    return options;
  }
};

TEST_F(DrawingTest, ScriptsThatStartProgramsOrWriteFilesAreRefused) {
  for (const char* command :
       {"SystemCall \"touch x\";", "System \"touch x\";", "NonBlockingSystemCall \"touch x\";", "OnelabRun(\"x\");"})
    expect_contains(refused(std::string("Point(1) = {0, 0, 0};\n") + command), "script.geo: line 2: \"");
  expect_contains(refused("SystemCall \"x\";"), "starts a program, which a drawing has no need of");
  expect_contains(refused("SystemCall \"x\";"), "--trust-geometry");
  for (const char* command : {"Save \"x.msh\";", "Print \"x.png\";", "CreateDir \"x\";", "Printf(\"a (b\", 1) > \"x\";",
                              "Printf(\"a\") >> \"x\";"})
    expect_contains(refused(command), "writes a file");
  for (const char* hidden : {"Printf(\nSystemCall \"x\";", "StringToName[\"System\"] \"x\";", "Solver.Name0 = \"x\";",
                             "Field[1] = ExternalProcess;", "Field[1].CommandLine = \"x\";",
                             "If(0)\nPrintf(\nEndIf\nSystemCall \"x\";", "SetString(\"a\", \"b\");"})
    expect_contains(refused(hidden), "starts a program");
  for (const char* option : {"General.ErrorFileName = \"x\";", "General . SaveOptions = 1;", "PostProcessing.X = 1;"})
    expect_contains(refused(option), "sets options");
  expect_contains(refused("Plugin(Bubbles).Run;"), "writes a file");
  expect_contains(refused("If(0)\nit's\nEndIf\nSystemCall 'x'; //'"), "line 2: a text does not end in its line");
  expect_contains(refused("a = \"" + std::string(1024, 'A') + "\";"), "a text is longer than 1000 characters");
  expect_contains(refused(std::string("// \0", 4) + "\nSystemCall \"x\";"), "zero byte");
  for (const char* file : {"x.py", "x.msh", "x.Step", "x"})
    expect_contains(refused(std::string("Merge \"") + file + "\";"), "may execute the file");
  written("shape.step.opt", "SystemCall \"x\";");
  expect_contains(refusal([&] { drawing_files(written("shape.step", ""), false); }),
                  "shape.step.opt: line 1: \"SystemCall\"");
  written("inner.stl", "SystemCall \"x\";");
  expect_contains(refused("Include \"inner.stl\";"), "inner.stl: line 1: \"SystemCall\"");
  expect_contains(refused("Include StrCat(\"a\", \"b.geo\");"), "does not name its file by a text");
  written("inner.geo", "// nothing\n\n/* nor\n here */ SystemCall \"x\";");
  // gmsh 4.8 executes each of these.
  for (const char* branching :
       {"If (0) \" EndIf SystemCall \"touch x\"; // \"\nEndIf", "For i In {1:2} /*\nSystemCall \"x\";\n*/\nEndFor",
        "Macro Foo /*\nSystemCall \"x\";\n*/\nReturn\nCall Foo;", "If (0)\n E/* EndIf SystemCall \"x\"; // */",
        "If (0)\n x = \"/*\";\n// */ EndIf SystemCall \"x\";"})
    expect_contains(refused(branching), "SystemCall");
  expect_contains(refused("For i In {1:2} /*\nPrintf(\"x\") > \"y\";\n*/\nEndFor"),
                  "\"Printf\" stands in a comment or a text");
  expect_contains(refused("Include /* \" */ \"b.geo\";"), "does not name its file by a text");
  for (const char* named_first : {"", "a = \"inner.geo\"; "})
    expect_contains(refused(std::string(named_first) + "Include \"inner.geo\";"), "inner.geo: line 4: \"SystemCall\"");
}

TEST_F(DrawingTest, TextsAndCommentsAreNoCommands) {
  written("inner.geo", "Include \"script.geo\"; Merge \"part.step\";");
  const std::string script =
      written("script.geo",
              "// SystemCall \"x\";\n/* Save \"x\"; */ Physical Curve(\"SystemCall\") = {1};\n"
              "Mesh.SaveAll = 1; SystemCallCount = 1; Printf(\"a > b\", 1 > 2); General.Terminal = 1;\n"
              "Include \"inner.geo\"; Merge \"none.geo\";");
  written("part.step", "");
  const std::vector<std::string> files = drawing_files(script, false);
  ASSERT_EQ(files.size(), 3);
  EXPECT_EQ(files[1], folder_.path() + "/inner.geo");
  EXPECT_EQ(files[2], folder_.path() + "/part.step");
  EXPECT_EQ(drawing_files(written("system.geo", "SystemCall \"x\";"), true).size(), 1) << "trusted";
  EXPECT_NE(test::file_failure([&] { drawing_files(folder_.path() + "/none.geo", false); }), "");
}

TEST_F(DrawingTest, EndingsTellDrawingsFromMeshes) {
  for (const char* path : {"a.geo", "a.STEP", "b/a.stp", "a.brep", "a.igs"}) EXPECT_TRUE(is_drawing(path)) << path;
  for (const char* path : {"a.msh", "a", "a.geo/b", "a.e", "a.Step"}) EXPECT_FALSE(is_drawing(path)) << path;
}

// The area of a quarter of a ring is pi/4 (r^2 - 1). Straight sides miss a share of the second order in their length,
// sides that follow the circle one of the fourth.
TEST_F(GmshTest, AScriptBecomesAMesh) {
  const double exact = M_PI / 4 * 3;
  const Mesh coarse = mesh_of(ring(), sized(0.2)), fine = mesh_of(ring(), sized(0.1));
  EXPECT_EQ(coarse.dimension, 2);
  ASSERT_EQ(coarse.blocks.size(), 1);
  EXPECT_EQ(coarse.blocks[0].name, "ring");
  ASSERT_EQ(coarse.side_sets.size(), 1);
  EXPECT_EQ(coarse.side_sets[0].name, "hole");
  EXPECT_GT(fine.nodes(), 3 * coarse.nodes());
  EXPECT_NEAR(test::volume(coarse), exact, 0.01);
  DrawingOptions curved = sized(0.2);
  curved.order = 2;
  EXPECT_NEAR(test::volume(mesh_of(ring(), curved)), exact, 1e-4);
  DrawingOptions larger = sized(0.2);
  larger.constants.set("radius", 3.0);
  EXPECT_NEAR(test::volume(mesh_of(ring(), larger)), M_PI / 4 * 8, 0.02);
  DrawingOptions halved = sized(0.2);
  halved.factor = 0.5;
  EXPECT_EQ(mesh_of(ring(), halved).nodes(), fine.nodes());
  DrawingOptions unknown = sized(0.2);
  unknown.constants.set("radus", 3.0);
  expect_contains(refusal([&] { drawn_mesh(ring(), unknown); }),
                  "Drawing/Constants/radus: no script of the drawing has such a name");
  DrawingOptions scaled = sized(0.2e-6);
  scaled.length_unit = 1e-6;
  EXPECT_EQ(mesh_of(ring(), scaled).nodes(), coarse.nodes()) << "sizes are in the unit of the scene";
}

TEST_F(GmshTest, CellsHaveTheSizesOfGroupsAndBoxes) {
  const auto on_hole = [](const Mesh& mesh) { return mesh.side_sets.at(0).sides.size(); };
  const Mesh plain = mesh_of(ring(), sized(0.3));
  DrawingOptions options = sized(0.3);
  options.local.push_back({"hole", 0.05, "", {}, {}});
  const Mesh local = mesh_of(ring(), options);
  EXPECT_NEAR(static_cast<double>(on_hole(local)), M_PI / 2 / 0.05, 2);
  EXPECT_LT(on_hole(plain), 10);
  options.local[0] = {"inside", 0.05, "", {-0.1, -0.1}, {1.1, 1.1}};
  EXPECT_NEAR(static_cast<double>(on_hole(mesh_of(ring(), options))), M_PI / 2 / 0.05, 4);
  options.local[0] = {"within", 0.05, "", {0.7, 0.7}, {0.8, 0.8}};  // no point of the drawing is there
  const Mesh within = mesh_of(ring(), options);
  int there = 0;
  for (std::size_t k = 0; k < within.coordinates.size(); k += 2)
    there +=
        std::abs(within.coordinates[k] - 0.75) < 0.051 && std::abs(within.coordinates[k + 1] - 0.75) < 0.051 ? 1 : 0;
  EXPECT_GE(there, 4);
  EXPECT_LT(within.nodes(), local.nodes());
  options.local[0] = {"inside", 0.05, "", {1.1, -0.1}, {-0.1, 1.1}};
  expect_contains(refusal([&] { drawn_mesh(ring(), options); }), "Lower 1.1 is above Upper -0.1 in direction x");
  options.local[0] = {"inside", 0.05, "", {-0.1, -0.1}, {1.1, 1.1}};
  const std::string own_field = ring("Field[1] = MathEval; Field[1].F = \"0.2\"; Background Field = 1;\n");
  expect_contains(refusal([&] { drawn_mesh(own_field, options); }), "the Background Field that the drawing sets");
  options.local[0] = {"inside", 0.05, "rim", {}, {}};
  expect_contains(refusal([&] { drawn_mesh(ring(), options); }),
                  "Drawing/Size At/inside: there is no physical group \"rim\"; there are \"hole\", \"ring\"");
  options.local[0] = {"inside", 0.05, "", {0.0}, {1.1}};
  expect_contains(refusal([&] { drawn_mesh(ring(), options); }), "Lower and Upper have 1 and 1 numbers");
}

TEST_F(GmshTest, AStepFileBecomesAMesh) {
  const std::string step = folder_.path() + "/block.step";
  ASSERT_EQ(std::system(("gmsh -0 " + block() + " -o " + step + " > /dev/null 2>&1").c_str()), 0);
  const Mesh mesh = mesh_of(step, sized(0.3));
  EXPECT_EQ(mesh.dimension, 3);
  EXPECT_NEAR(test::volume(mesh), 8 - M_PI / 4, 0.04);
  DrawingOptions options = sized(0.3);
  options.order = 2;
  options.local.push_back({"end", 0.1, "", {-0.1, -0.1, -0.1}, {0.1, 2.1, 1.1}});
  const Mesh graded = mesh_of(step, options);
  EXPECT_NEAR(test::volume(graded), 8 - M_PI / 4, 0.002);
  EXPECT_GT(graded.nodes(), 2 * mesh.nodes());
  options.dimension = 2;
  EXPECT_NE(drawn_mesh(step, options).path, drawn_mesh(step, sized(0.3)).path);
}

TEST_F(GmshTest, AMeshIsMadeOnce) {
  const std::string first = drawn_mesh(ring(), sized(0.3)).path;
  const auto time = std::filesystem::last_write_time(first);
  EXPECT_EQ(drawn_mesh(ring(), sized(0.3)).path, first);
  EXPECT_EQ(std::filesystem::last_write_time(first), time);
  EXPECT_NE(drawn_mesh(ring(), sized(0.25)).path, first);
  EXPECT_NE(drawn_mesh(ring("// changed\n"), sized(0.3)).path, first);
  written("inner.geo", "a = 1;");
  const std::string including = drawn_mesh(ring("Include \"inner.geo\";\n"), sized(0.3)).path;
  written("inner.geo", "a = 2;");
  EXPECT_NE(drawn_mesh(ring("Include \"inner.geo\";\n"), sized(0.3)).path, including);
  written("places.dat", "1 2");
  const std::string reading = drawn_mesh(ring("b() = ListFromFile(\"places.dat\");\n"), sized(0.3)).path;
  written("places.dat", "1 3");
  EXPECT_NE(drawn_mesh(ring("b() = ListFromFile(\"places.dat\");\n"), sized(0.3)).path, reading);
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(first).parent_path())) {
    const std::string ending = entry.path().extension().string();
    EXPECT_TRUE(ending == ".msh" || ending == ".log") << entry.path();
  }
}

TEST_F(GmshTest, WhatGmshSaysIsPassedOn) {
  const std::string message = refusal([&] { drawn_mesh(ring("Line(9) = {1, 99};\n"), sized(0.3)); });
  expect_contains(message, "ring.geo: gmsh says: ");
  expect_contains(message, "99");
  expect_contains(refusal([&] { drawn_mesh(ring("oops\n"), sized(0.3)); }), "syntax error");
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder_.path().c_str(), 1);
  expect_contains(refusal([&] { drawn_mesh(ring(), sized(0.3)); }),
                  "it takes the program gmsh, which is not on the PATH");
  setenv("PATH", path.c_str(), 1);
}

TEST_F(GmshTest, ScriptsOfTrustMayStartPrograms) {
  const std::string script = ring("SystemCall \"touch " + folder_.path() + "/touched\";\n");
  expect_contains(refusal([&] { drawn_mesh(script, sized(0.3)); }), "ring.geo: line 7: \"SystemCall\"");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() + "/touched"));
  trust_geometry();
  drawn_mesh(script, sized(0.3));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() + "/touched"));
}

}  // namespace
}  // namespace ixos
