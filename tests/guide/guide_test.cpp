// The recipes of docs/developer-guide.md, compiled and tested as they stand there; structure/guide_test.py compares.
#include <gtest/gtest.h>

#include "fem/quadrature.hpp"
#include "histories/catalogue.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/obstacle.hpp"
#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"
#include "mesh/generators/entry.hpp"
#include "mesh/quality.hpp"
#include "parameters/validation.hpp"
#include "rule/rule.hpp"
#include "time/table.hpp"

namespace ixos {

LawEntry foundation_law();
ElasticEntry soft_rubber_entry();
ObstacleEntry slit_obstacle();
MeshEntry sheared_mesh();
HistoryEntry decay_history();

namespace {

Table midpoint() {
  const Row du = unknown_displacement() - displacement(0);
  Stage stage;
  stage.velocity = 2 * du - velocity(0);  // u - u_n = dt (v_n + v)/2
  stage.acceleration = 4 * du - 4 * velocity(0) - acceleration(0);
  stage.inertia = stage.velocity - velocity(0);  // M (v - v_n)/dt
  stage.damping = du;                            // C (u - u_n)/dt
  stage.elastic = point_rule({0.5}, {1.0});      // forces at (u_n + u)/2
  stage.interaction = point_rule({0.5}, {1.0});
  stage.rate_form = RateForm::Middle;  // viscosity: see RateForm
  stage.load = {{0.5, 1.0}};           // f_ext at t_n + dt/2
  return {"Midpoint", {stage}, Closing::Collocate, {WorkSum::Form::Increment, {}}, Predictor::LastDisplacement};
}

TEST(GuideTest, TheSchemeIsConsistent) { EXPECT_NO_THROW(check(midpoint())); }

/// Makes an entry with its defaults; `set` gives what they lack.
template <class Entry, class Set, class... Context>
auto made(const Entry& entry, const Set& set, Context... context) {
  const Catalogue<Entry> catalogue("Type", "", {entry});
  Teuchos::ParameterList valid, user;
  catalogue.declare(valid);
  user.set("Type", entry.name);
  set(entry.in_place ? user : user.sublist(entry.name));
  const Teuchos::ParameterList complete = validated(user, valid);
  return catalogue.make(SceneNode(complete, ""), context...);
}
const auto nothing = [](Teuchos::ParameterList&) {};

TEST(GuideTest, TheLawsMeanIsTheIntegral) {
  const auto law = made(foundation_law(), nothing);
  const double r0 = 0.3, r1 = 0.9;
  EXPECT_NEAR(law->mean_traction(r0, r1)[0] * (r1 - r0), law->energy(r0)[0] - law->energy(r1)[0], 1e-16);
}

TEST(GuideTest, TheMaterialsStressDoesTheWork) {
  const auto law = made(soft_rubber_entry(), nothing);
  // By Gauss points along a straight line in H.
  const Quadrature gauss = gauss_legendre_unit(20);
  Small<Pack, 2> h{};
  const double target[2][2] = {{0.2, -0.1}, {0.3, 0.1}};
  double work = 0;
  for (std::size_t q = 0; q < gauss.points.size(); ++q) {
    Small<Pack, 2> p;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) h[i][j] = gauss.points[q] * target[i][j];
    law->stress(h, p);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) work += gauss.weights[q] * p[i][j][0] * target[i][j];
  }
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) h[i][j] = target[i][j];
  EXPECT_NEAR(law->energy(h)[0], work, 1e-14);
}

TEST(GuideTest, TheObstacleHasTwoWalls) {
  const auto slit = made(
      slit_obstacle(), [](Teuchos::ParameterList& list) { list.set("Height", 4.0); }, std::size_t{2});
  EXPECT_EQ(slit->at({0.0, 1.0, 0.0}).gap[0], 1);
  EXPECT_EQ(slit->at({0.0, 3.5, 0.0}).gap[0], 0.5);
  EXPECT_EQ(slit->at({0.0, 3.5, 0.0}).normal[1][0], -1);
}

TEST(GuideTest, TheMeshIsSound) {
  const Mesh mesh = made(sheared_mesh(), nothing);
  EXPECT_EQ(mesh.cells(), 16);
  EXPECT_NO_THROW(check_cells(mesh));
}

TEST(GuideTest, TheHistorysDerivativesFit) {
  const auto decay = made(decay_history(), [](Teuchos::ParameterList& list) { list.set("Time", 2.0); });
  EXPECT_NO_THROW(check_over(*decay, 0, 5, true));
}

}  // namespace
}  // namespace ixos
