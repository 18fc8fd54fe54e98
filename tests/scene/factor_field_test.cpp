// Factors of interactions from nodal fields of the mesh file: scenes that read them, and their refusals.
#include <gtest/gtest.h>

#include <exodusII.h>

#include <cmath>
#include <functional>

#include "interaction/gap_law.hpp"
#include "io/exodus_mesh.hpp"
#include "mesh/generators/shapes.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::numbers;
using test::word;

const std::string file = testing::TempDir() + "factor_field.e";

/// Writes a block of 3 by 2 L0 (and 1 deep) whose bottom is at 0.4, with the nodal field "strength" of the places.
void write_block(int dimension, const std::function<double(const double*)>& strength) {
  const Comm comm = test::world();
  if (comm->getRank() == 0) {
    BoxShape shape;
    shape.dimension = dimension;
    shape.lower = {0, dimension == 2 ? 0.4 : 0, 0.4};
    shape.lengths = {3, 2, 1};
    shape.divisions = {6, 4, 2};
    const Mesh mesh = box(shape);
    write_exodus_mesh(mesh, file, "block");
    int word = 8, stored = 0;
    float version = 0;
    const int id = ex_open(file.c_str(), EX_WRITE, &word, &stored, &version);
    char name[] = "strength";
    char* names[] = {name};
    EXPECT_GE(ex_put_variable_param(id, EX_NODAL, 1), 0);
    EXPECT_GE(ex_put_variable_names(id, EX_NODAL, 1, names), 0);
    const double time = 0;
    EXPECT_GE(ex_put_time(id, 1, &time), 0);
    std::vector<double> values;
    for (int node = 0; node < mesh.nodes(); ++node)
      values.push_back(strength(&mesh.coordinates[static_cast<std::size_t>(node * dimension)]));
    EXPECT_GE(ex_put_var(id, 1, EX_NODAL, 1, 1, mesh.nodes(), values.data()), 0);
    EXPECT_GE(ex_close(id), 0);
  }
  comm->barrier();
}

std::string from_file(int order = 1) {
  return list("Mesh", word("Type", "Exodus") + test::count("Cell Order", order) + list("Exodus", word("File", file)));
}

/// The block over the wall at 0.
Teuchos::ParameterList scene(const std::string& mesh, const std::string& interaction) {
  return test::scene(mesh + list("Materials", list("Rubber", "")) +
                     list("Interactions", list("Wall", word("Side Set", "bottom") + interaction)) +
                     test::time_integrator("Newmark", 0.1, 1));
}

TEST(FactorFieldTest, TheFieldScalesTheForceOverTheSurface) {
  const std::string field = word("Factor Field", "strength");
  for (const std::string element : {"Q1C1", "Q1C2", "Q1C4", "Q1CH", "Q2C2", "Q2C4"}) {
    const int order = element[1] == '2' ? 2 : 1;
    write_block(2, [](const double* x) { return x[0]; });
    const Simulation plane(scene(from_file(order), field + word("Contact Element", element)), test::world());
    const Model& model = plane.model();
    const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
    const double alone = test::ReportAt(model, rest.data()).interaction_report().force[1];
    EXPECT_NEAR(alone, 4.5 * plane.interactions()[0].law->traction(0.4)[0], 1e-12) << element;
    const Simulation both(scene(from_file(order), field + word("Factor", "2*x") + word("Contact Element", element)),
                          test::world());
    const double product = test::ReportAt(both.model(), rest.data()).interaction_report().force[1];
    // int x dx = 4.5, int 2 x^2 dx = 18 over 0 to 3.
    EXPECT_NEAR(product, 4 * alone, 1e-12 * std::abs(product)) << element;

    write_block(3, [](const double* x) { return 1 + x[0] * x[1]; });  // bilinear on each face
    const Simulation solid(scene(from_file(order), field + word("Contact Element", element) +
                                                       numbers("Normal", {0, 0, 1}) + numbers("Point", {0, 0, 0})),
                           test::world());
    const Simulation plain(scene(from_file(order), word("Contact Element", element) + numbers("Normal", {0, 0, 1}) +
                                                       numbers("Point", {0, 0, 0})),
                           test::world());
    const std::vector<double> still(static_cast<std::size_t>(solid.model().space().local()), 0.0);
    const double scaled = test::ReportAt(solid.model(), still.data()).interaction_report().force[2];
    const double whole = test::ReportAt(plain.model(), still.data()).interaction_report().force[2];
    // int 1 + x y dA = 6 + 9/2 2 = 15 over 3 by 2.
    EXPECT_NEAR(scaled, 15.0 / 6 * whole, 1e-12 * std::abs(whole)) << element;
  }
}

TEST(FactorFieldTest, TheFieldCountsForTheFingerprint) {
  write_block(2, [](const double*) { return 1.0; });
  const std::string of_field = word("Factor Field", "strength");
  const Simulation plain(scene(from_file(), ""), test::world()), one(scene(from_file(), of_field), test::world());
  write_block(2, [](const double*) { return 2.0; });
  const Simulation other(scene(from_file(), ""), test::world()), two(scene(from_file(), of_field), test::world());
  EXPECT_EQ(plain.mesh_fingerprint(), other.mesh_fingerprint());
  EXPECT_NE(one.mesh_fingerprint(), two.mesh_fingerprint());
  EXPECT_NE(one.mesh_fingerprint(), plain.mesh_fingerprint());
}

TEST(FactorFieldTest, SeveralInteractionsMayShareAField) {
  write_block(2, [](const double* x) { return x[0]; });
  const std::string wall = word("Side Set", "bottom") + word("Factor Field", "strength");
  const Simulation twice(
      test::scene(from_file() + list("Materials", list("Rubber", "")) +
                  list("Interactions", list("Wall", wall) + list("Second Wall", wall + word("Factor", "2"))) +
                  test::time_integrator("Newmark", 0.1, 1)),
      test::world());
  const std::vector<double> rest(static_cast<std::size_t>(twice.model().space().local()), 0.0);
  // int x dx = 4.5 over 0 to 3, once and twice.
  EXPECT_NEAR(test::ReportAt(twice.model(), rest.data()).interaction_report().force[1],
              3 * 4.5 * twice.interactions()[0].law->traction(0.4)[0], 1e-12);
}

TEST(FactorFieldTest, UnsoundFieldsAreRefused) {
  const auto refusal = [](const std::string& mesh, const std::string& field) {
    return test::refusal([&] { Simulation(scene(mesh, word("Factor Field", field)), test::world()); });
  };
  write_block(2, [](const double* x) { return x[1] > 1 ? -1.0 : 1.0; });
  EXPECT_EQ(refusal(from_file(), "strength"), "") << "values away from the surface do not count";
  write_block(2, [](const double* x) { return x[0] > 2.9 ? -0.25 : 1.0; });
  test::expect_contains(refusal(from_file(), "strength"), "Interactions/Wall");
  test::expect_contains(refusal(from_file(), "strength"), "the factor at node ");
  test::expect_contains(refusal(from_file(), "strength"), "is -0.25; it must be finite and at least 0");
  test::expect_contains(refusal(from_file(), "strenth"),
                        "Interactions/Wall/Factor Field: " + file +
                            ": nodal field \"strenth\" does not exist; did you mean \"strength\"?");
  const std::string pair = word("Primary Side Set", "top") + word("Passes", "Two");
  test::expect_contains(
      test::refusal([&] { Simulation(scene(from_file(), word("Factor Field", "strength") + pair), test::world()); }),
      "Interactions/Wall/Passes: \"Two\" is not there with a factor");
  const std::string box = list("Mesh", word("Type", "Box") + list("Box", numbers("Lower", {0, 0.4})));
  test::expect_contains(refusal(box, "strength"), "Interactions/Wall/Factor Field");
  test::expect_contains(refusal(box, "strength"), "is a field of an Exodus file, but Mesh/Type is Box");
}

}  // namespace
}  // namespace ixos
