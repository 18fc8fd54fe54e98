// The semi-discrete model as other Trilinos programs see it.
#include "embedding/semi_discrete_evaluator.hpp"

#include <gtest/gtest.h>

#include <Thyra_MultiVectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include "solve/semi_discrete_bodies.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"

namespace ixos {
namespace {

using Base = Thyra::ModelEvaluatorBase;

using test::belos;
using Example = test::EvaluatorExample;

/// Applies an operator to several columns at once, and column by column.
void expect_columns(const Thyra::LinearOpBase<double>& op) {
  const int columns = 3;
  const auto x = Thyra::createMembers(op.domain(), columns), y = Thyra::createMembers(op.range(), columns);
  Thyra::seed_randomize<double>(7);
  Thyra::randomize(-1.0, 1.0, x.ptr());
  Thyra::apply(op, Thyra::NOTRANS, *x, y.ptr());
  for (int j = 0; j < columns; ++j) {
    const auto single = Thyra::createMember(op.range());
    Thyra::apply(op, Thyra::NOTRANS, *x->col(j), single.ptr());
    EXPECT_LT(test::relative_distance(*y->col(j), *single), 1e-12) << "column " << j;
    EXPECT_GT(Thyra::norm_2(*single), 0);
  }
  const auto before = y->clone_mv();
  Thyra::apply(op, Thyra::NOTRANS, *x, y.ptr(), 2.0, -1.0);  // y = 2 op x - y
  for (int j = 0; j < columns; ++j) EXPECT_LT(test::relative_distance(*y->col(j), *before->col(j)), 1e-12);
}

TEST(SemiDiscreteEvaluatorTest, EveryOperatorTakesSeveralColumns) {
  for (const char* op : {"Assembled", "Matrix-Free"})
    for (const char* preconditioner : {"MueLu", "Direct", "Chebyshev"}) {
      SCOPED_TRACE(std::string(op) + ", " + preconditioner);
      const Example e(3, belos(preconditioner, op));
      const auto w = e.evaluator.create_W_op();
      const auto prec = e.evaluator.create_W_prec();
      auto out = e.evaluator.createOutArgs();
      out.set_W_op(w);
      out.set_W_prec(prec);
      e.evaluator.evalModel(e.in, out);
      expect_columns(*w);
      expect_columns(*prec->getUnspecifiedPrecOp());
    }
  const Example e;
  for (const auto& op : {e.evaluator.mass(), e.evaluator.damping(e.in), e.evaluator.stiffness(e.in)})
    expect_columns(*op);
}

TEST(SemiDiscreteEvaluatorTest, WIsTheSumOfItsPartsOnFreeDegreesOfFreedom) {
  for (const char* kind : {"Assembled", "Matrix-Free"}) {
    const Example e(3, belos("Chebyshev", kind));
    const auto w = e.evaluator.create_W_op();
    auto out = e.evaluator.createOutArgs();
    out.set_W_op(w);
    e.evaluator.evalModel(e.in, out);
    Vector free = test::wave(e.model, 1, 5);
    const auto clear = [&e](Vector& x) {
      const auto view = x.getLocalViewHost(Tpetra::Access::ReadWrite);
      for (std::size_t i = 0; i < view.extent(0); ++i)
        if (e.model.constraints().holds(static_cast<int>(i))) view(i, 0) = 0;
    };
    clear(free);
    const auto x = test::thyra(free), product = x->clone_v(), sum = x->clone_v(), all = x->clone_v();
    Thyra::apply(*w, Thyra::NOTRANS, *x, product.ptr());
    Thyra::apply(*e.evaluator.mass(), Thyra::NOTRANS, *x, sum.ptr(), 40.0, 0.0);
    Thyra::apply(*e.evaluator.damping(e.in), Thyra::NOTRANS, *x, sum.ptr(), 2.0, 1.0);
    Thyra::apply(*e.evaluator.stiffness(e.in), Thyra::NOTRANS, *x, sum.ptr(), 1.0, 1.0);
    Thyra::apply(*e.evaluator.unconstrained_W(e.in), Thyra::NOTRANS, *x, all.ptr());
    EXPECT_LT(test::relative_distance(*all, *sum), 1e-13);
    clear(*Extract::getTpetraVector(sum));
    EXPECT_LT(test::relative_distance(*product, *sum), 1e-6) << kind;  // elastic actions keep single precision
    // A constrained degree of freedom is multiplied by beta alone.
    const auto one = test::thyra(test::wave(e.model, 1, 5));
    Thyra::Vp_StV(one.ptr(), -1.0, *x);
    Thyra::apply(*w, Thyra::NOTRANS, *one, product.ptr());
    EXPECT_LT(test::relative_distance(*product, *one), 1e-13) << kind;
  }
}

TEST(SemiDiscreteEvaluatorTest, NodalForcesSumToFOnFreeDegreesOfFreedom) {
  const Example e;
  const auto f = Thyra::createMember(e.evaluator.get_f_space()), sum = f->clone_v(), part = f->clone_v();
  auto out = e.evaluator.createOutArgs();
  out.set_f(f);
  e.evaluator.evalModel(e.in, out);
  Thyra::assign(sum.ptr(), 0.0);
  for (const auto& [kind, sign] : {std::pair{NodalForce::Inertia, 1.0},
                                   {NodalForce::Damping, 1.0},
                                   {NodalForce::Elastic, 1.0},
                                   {NodalForce::Interaction, 1.0},
                                   {NodalForce::External, -1.0}}) {
    EXPECT_TRUE(e.evaluator.nodal_force(kind, e.in, part.ptr()));
    EXPECT_GT(Thyra::norm_2(*part), 0);
    Thyra::Vp_StV(sum.ptr(), sign, *part);
  }
  for (const auto& x : {f, sum}) {
    const auto view = Extract::getTpetraVector(x)->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      if (e.model.constraints().holds(static_cast<int>(i))) view(i, 0) = 0;
  }
  EXPECT_LT(test::relative_distance(*sum, *f), 1e-14);
}

TEST(SemiDiscreteEvaluatorTest, ResponsesAreReplicatedAndThoseOfTheModel) {
  const Example e;
  auto out = e.evaluator.createOutArgs();
  ASSERT_EQ(out.Ng(), 4);
  for (int j = 0; j < out.Ng(); ++j) out.set_g(j, Thyra::createMember(e.evaluator.get_g_space(j)));
  e.evaluator.evalModel(e.in, out);
  std::vector<double> u(static_cast<std::size_t>(e.model.space().local()));
  e.model.space().import(test::wave(e.model, 0.02, 0), u.data());
  EXPECT_DOUBLE_EQ(Thyra::get_ele(*out.get_g(0), 1), test::ReportAt(e.model, u.data()).energy(Part::Elastic));
  EXPECT_DOUBLE_EQ(Thyra::get_ele(*out.get_g(0), 2), test::ReportAt(e.model, u.data()).energy(Part::Interaction));
  const InteractionReport report = test::ReportAt(e.model, u.data()).interaction_report();
  EXPECT_DOUBLE_EQ(Thyra::get_ele(*out.get_g(2), 1), report.force[1]);
  EXPECT_DOUBLE_EQ(Thyra::get_ele(*out.get_g(2), 3), report.least_gap);
  EXPECT_EQ(e.evaluator.get_g_names(2)[3], "min_gap");
  EXPECT_EQ(e.evaluator.get_g_names(3)[0], "reaction_left_x");
}

TEST(SemiDiscreteEvaluatorTest, GradientsOfEnergiesAreTheirDifferenceQuotients) {
  const Example e;
  auto out = e.evaluator.createOutArgs();
  const auto by_x = Thyra::createMembers(e.evaluator.get_x_space(), 3), by_x_dot = by_x->clone_mv();
  out.set_DgDx(0, Base::Derivative<double>(by_x, Base::DERIV_MV_GRADIENT_FORM));
  out.set_DgDx_dot(0, Base::Derivative<double>(by_x_dot, Base::DERIV_MV_GRADIENT_FORM));
  e.evaluator.evalModel(e.in, out);
  const auto direction = test::thyra(test::wave(e.model, 1, 4));
  const double h = 1e-5;
  const auto quotient = [&](bool velocity, int component) {
    double difference = 0;
    for (const double sign : {1.0, -1.0}) {
      auto in = e.in;
      const auto moved = (velocity ? in.get_x_dot() : in.get_x())->clone_v();
      Thyra::Vp_StV(moved.ptr(), sign * h, *direction);
      if (velocity) in.set_x_dot(moved);
      if (!velocity) in.set_x(moved);
      auto at = e.evaluator.createOutArgs();
      at.set_g(0, Thyra::createMember(e.evaluator.get_g_space(0)));
      e.evaluator.evalModel(in, at);
      difference += sign * Thyra::get_ele(*at.get_g(0), component);
    }
    return difference / (2 * h);
  };
  for (int component = 0; component < 3; ++component) {
    const double slope = quotient(false, component), by_velocity = quotient(true, component);
    EXPECT_NEAR(Thyra::dot(*by_x->col(component), *direction), slope, 1e-7 * (std::abs(slope) + 1e-3));
    EXPECT_NEAR(Thyra::dot(*by_x_dot->col(component), *direction), by_velocity, 1e-7 * (std::abs(by_velocity) + 1e-3));
  }
  EXPECT_GT(std::abs(Thyra::dot(*by_x->col(1), *direction)), 1e-2);
  EXPECT_GT(std::abs(Thyra::dot(*by_x_dot->col(0), *direction)), 1e-2);
}

TEST(SemiDiscreteEvaluatorTest, AnInadmissibleStateFailsInEveryOutput) {
  for (const char* kind : {"Assembled", "Matrix-Free"}) {
    const Example e(3, belos("Direct", kind));
    const auto bad = e.inadmissible();
    auto all = e.evaluator.createOutArgs();
    const auto f = Thyra::createMember(e.evaluator.get_f_space());
    const auto w = e.evaluator.create_W_op();
    const auto gradient = Thyra::createMembers(e.evaluator.get_x_space(), 3);
    all.set_f(f);
    all.set_W_op(w);
    all.set_g(0, Thyra::createMember(e.evaluator.get_g_space(0)));
    all.set_DgDx(0, Base::Derivative<double>(gradient, Base::DERIV_MV_GRADIENT_FORM));
    e.evaluator.evalModel(bad, all);
    const auto product = f->clone_v(), ones = f->clone_v();
    Thyra::assign(ones.ptr(), 1.0);
    Thyra::apply(*w, Thyra::NOTRANS, *ones, product.ptr());
    for (const auto& x : {f, product, gradient->col(0), gradient->col(2)}) EXPECT_TRUE(std::isnan(Thyra::norm_2(*x)));
    EXPECT_TRUE(std::isnan(Thyra::get_ele(*all.get_g(0), 0)));
    EXPECT_FALSE(e.evaluator.nodal_force(NodalForce::Elastic, bad, f.ptr()));
    EXPECT_TRUE(std::isnan(Thyra::norm_2(*f)));
    EXPECT_FALSE(e.evaluator.nodal_force(NodalForce::External, bad, f.ptr()));
    EXPECT_GT(Thyra::norm_2(*f), 0);
    Thyra::apply(*e.evaluator.stiffness(bad), Thyra::NOTRANS, *ones, product.ptr());
    EXPECT_TRUE(std::isnan(Thyra::norm_2(*product)));
    // W_op alone is judged too, and the next admissible state mends it.
    auto only = e.evaluator.createOutArgs();
    only.set_W_op(w);
    e.evaluator.evalModel(e.in, only);
    Thyra::apply(*w, Thyra::NOTRANS, *ones, product.ptr());
    EXPECT_GT(Thyra::norm_2(*product), 0);
    e.evaluator.evalModel(bad, only);
    Thyra::apply(*w, Thyra::NOTRANS, *ones, product.ptr());
    EXPECT_TRUE(std::isnan(Thyra::norm_2(*product)));
  }
}

TEST(SemiDiscreteEvaluatorTest, LawsWithAHistoryAreRefused) {
  const std::string bond = test::list(
      "Bond", test::word("Side Set", "top") + test::word("Law", "Bilinear Damage") +
                  test::list("Bilinear Damage", test::number("Work of Adhesion", 0.02) +
                                                    test::number("Strength", 0.05) + test::number("Stiffness", 0.5)));
  const auto scene = [](const std::string& interactions) {
    return test::scene(
        test::list("Mesh", test::word("Type", "Box") + test::list("Box", test::numbers("Lengths", {2, 1}) +
                                                                             test::counts("Divisions", {2, 1}))) +
        test::list("Materials", test::list("Rubber", test::number("Density", 1))) + interactions +
        test::time_integrator("Newmark", 0.1, 1));
  };
  const Simulation plain(scene(""), test::world()), bonded(scene(test::list("Interactions", bond)), test::world());
  EXPECT_FALSE(has_histories(plain.model()));
  EXPECT_TRUE(has_histories(bonded.model()));
  EXPECT_EQ(test::refusal([&] { SemiDiscreteEvaluator{plain.model()}; }), "");
  EXPECT_EQ(
      test::refusal([&] { SemiDiscreteEvaluator{bonded.model()}; }),
      "an interaction's law or a material has a history, which follows the steps of an Integrator; the evaluator has "
      "none");
}

}  // namespace
}  // namespace ixos
