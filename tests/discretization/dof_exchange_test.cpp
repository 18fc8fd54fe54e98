#include "discretization/dof_exchange.hpp"

#include <gtest/gtest.h>

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <stdexcept>

#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

/// 4 by 3 cells; the program has `last` - 2 node - component for the displacements and some more unknowns, shared out
/// in equal parts: other ranks own them than own the nodes.
struct Exchanged {
  explicit Exchanged(Mesh whole = grid()) : comm(test::world()), mesh(local_part(whole, comm)), space(mesh, comm) {}

  static Mesh grid() {
    BoxShape shape;
    shape.divisions = {4, 3, 1};
    return box(shape);
  }
  static GlobalId number(GlobalId node, int component) { return 50 - 2 * node - component; }
  static double value(GlobalId node, int component) { return 1.0 + 10.0 * static_cast<double>(node) + component; }

  /// 10 to 59; the displacements have 11 to 50.
  Teuchos::RCP<const Map> map() const { return Teuchos::rcp(new Map(50, 10, comm)); }
  DofExchange exchange() const { return {mesh, space, map(), number}; }
  /// A local array of value(); ghosts are zero if they are not wanted.
  std::vector<double> field(bool ghosts) const {
    std::vector<double> values(static_cast<std::size_t>(space.local()), 0.0);
    for (int node = 0; node < (ghosts ? mesh.nodes() : mesh.owned_nodes); ++node)
      for (int i = 0; i < 2; ++i)
        values[static_cast<std::size_t>(2 * node + i)] = value(mesh.program_id(static_cast<std::size_t>(node)), i);
    return values;
  }

  Comm comm;
  LocalMesh mesh;
  DofSpace space;
};

/// Expects value() at the displacements, -7 elsewhere.
void expect_program_values(const Vector& program) {
  const auto view = program.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t k = 0; k < view.extent(0); ++k) {
    const GlobalId id = program.getMap()->getGlobalElement(static_cast<int>(k));
    const GlobalId number = 50 - id;
    const bool ours = number >= 0 && number < 40;
    EXPECT_EQ(view(k, 0), ours ? Exchanged::value(number / 2, static_cast<int>(number % 2)) : -7) << id;
  }
}

TEST(DofExchangeTest, ValuesGoToTheProgramAndBack) {
  const Exchanged part;
  const DofExchange exchange = part.exchange();
  Vector program(part.map());
  program.putScalar(-7);
  exchange.to_program(part.field(false), program);
  expect_program_values(program);
  std::vector<double> back;
  exchange.to_model(program, back);
  EXPECT_EQ(back, part.field(true));  // ghosts too
}

TEST(DofExchangeTest, OwnedVectorsOfSeveralColumnsDoTheSame) {
  const Exchanged part;
  const DofExchange exchange = part.exchange();
  MultiVector owned(part.space.owned_map(), 2), program(part.map(), 2), back(part.space.owned_map(), 2);
  const std::vector<double> values = part.field(false);
  for (std::size_t k = 0; k < owned.getLocalLength(); ++k) {
    owned.replaceLocalValue(static_cast<int>(k), 0, values[k]);
    owned.replaceLocalValue(static_cast<int>(k), 1, -2 * values[k]);
  }
  program.putScalar(-7);
  exchange.to_program(owned, program);
  expect_program_values(*program.getVector(0));
  exchange.to_model(program, back);
  back.update(-1.0, owned, 1.0);
  EXPECT_EQ(back.getVector(0)->normInf(), 0);
  EXPECT_EQ(back.getVector(1)->normInf(), 0);
}

TEST(DofExchangeTest, NodesThatAContactElementAddsAreLeftAlone) {
  Mesh mesh = Exchanged::grid();
  enrich(mesh, "bottom", ContactElement::Q1C3);
  const Exchanged part(mesh);
  Vector program(part.map());
  program.putScalar(-7);
  const DofExchange exchange = part.exchange();
  exchange.to_program(part.field(true), program);
  expect_program_values(program);
  std::vector<double> back(static_cast<std::size_t>(part.space.local()), 3.0);
  exchange.to_model(program, back);
  for (std::size_t node = 0; node < static_cast<std::size_t>(part.mesh.nodes()); ++node)
    EXPECT_EQ(back[2 * node], part.mesh.is_added(node) ? 3.0 : Exchanged::value(part.mesh.program_id(node), 0));
}

TEST(DofExchangeTest, WrongNumbersAreRefused) {
  const Exchanged part;
  const auto message = [&](const DofExchange::Number& number) {
    return test::refusal([&] { DofExchange(part.mesh, part.space, part.map(), number); });
  };
  test::expect_contains(message([](GlobalId node, int component) { return 60 + 2 * node + component; }),
                        "the program's map has no degree of freedom");
  test::expect_contains(message([](GlobalId node, int) { return 10 + node; }), "two displacements have the number");
  // The usual numbers, 0 to 39, are not in that map either.
  test::expect_contains(test::refusal([&] { DofExchange(part.mesh, part.space, part.map()); }), "no degree of freedom");
}

// The map of a program that knows linear cells lacks the middles; the message names what added them.
TEST(DofExchangeTest, TheMiddlesOfARaisedMeshAreNamed) {
  Mesh raised = Exchanged::grid();
  raise_order(raised);
  const Exchanged part(raised);
  const std::string message = test::refusal([&] { part.exchange(); });
  test::expect_contains(message, "no degree of freedom");
  test::expect_contains(message, "which Mesh/Cell Order 2 (raise_order()) added to the 20 nodes of the linear mesh");
  // With numbers for all nodes it is an exchange as any other.
  const auto all = Teuchos::rcp(new Map(2 * part.mesh.global_nodes, 0, part.comm));
  EXPECT_EQ(test::refusal([&] { DofExchange(part.mesh, part.space, all); }), "");
}

TEST(DofExchangeTest, NumbersThatCollideAcrossRanksOnlyAreRefused) {
  const Exchanged part;
  if (part.comm->getSize() == 1) GTEST_SKIP() << "needs several ranks";
  GlobalId next = 11;  // each rank numbers its own displacements from here
  const DofExchange::Number number = [&](GlobalId, int) { return next++; };
  test::expect_contains(test::refusal([&] { DofExchange(part.mesh, part.space, part.map(), number); }),
                        "displacements of two ranks have the same number");
}

TEST(DofExchangeTest, AMapWithGhostsIsRefused) {
  const Exchanged part;
  if (part.comm->getSize() == 1) GTEST_SKIP() << "needs several ranks";
  const Teuchos::RCP<const Map> everywhere = Teuchos::rcp(new Map(50, 10, part.comm, Tpetra::LocallyReplicated));
  test::expect_contains(test::refusal([&] { DofExchange(part.mesh, part.space, everywhere, Exchanged::number); }),
                        "has a degree of freedom on two ranks; pass a map without ghosts");
}

TEST(DofExchangeTest, AllRanksThrowIfTheNumberingThrowsOnOne) {
  const Exchanged part;
  const int last = part.comm->getSize() - 1;
  const DofExchange::Number number = [&](GlobalId node, int component) -> GlobalId {
    if (part.comm->getRank() == last) throw std::runtime_error("no number here");
    return Exchanged::number(node, component);
  };
  test::expect_contains(test::refusal([&] { DofExchange(part.mesh, part.space, part.map(), number); }),
                        "no number here");
}

}  // namespace
}  // namespace ixos
