/// Models, states and InArgs for the tests of the semi-discrete model.
#pragma once
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "embedding/semi_discrete_evaluator.hpp"
#include "scene/simulation.hpp"
#include "solve/choice/problem_size.hpp"
#include "support/scene_text.hpp"

namespace ixos::test {

/// A block of 4 by 2 (by 1) L0 with density 0.7 and damping, above a wall half an L0 below it. Its left side is held
/// at zero along all axes but x, along which it moves as 0.1 t; a traction pulls the right side along x.
inline std::unique_ptr<Simulation> held_block(int dimension, const std::string& material = "") {
  const bool plane = dimension == 2;
  const std::string box = plane
                              ? numbers("Lengths", {4, 2}) + counts("Divisions", {6, 3})
                              : count("Dimension", 3) + numbers("Lengths", {4, 2, 1}) + counts("Divisions", {4, 2, 2});
  const auto condition = [](const std::string& name, const std::string& components, const std::string& history) {
    return list(name, word("Node Set", "left") + word("Components", components) + history);
  };
  return std::make_unique<Simulation>(
      scene(list("Mesh", word("Type", "Box") + list("Box", box)) +
            list("Materials",
                 list("Rubber", number("Density", 0.7) + number("Poisson's Ratio", 0.3) + number("Mass Damping", 0.3) +
                                    number("Stiffness Damping", 0.2) + material)) +
            list("Interactions",
                 list("Wall", word("Side Set", "bottom") +
                                  numbers("Point", plane ? std::vector<double>{0, -0.5} : std::vector{0., 0., -0.5}))) +
            list("Histories", expression("Pull", "0.1*t", "0.1", "0") + expression("Load", "1+t")) +
            list("Boundary Conditions",
                 condition("Held", plane ? "y" : "yz", "") + condition("Pull", "x", word("History", "Pull")) +
                     list("Load", word("Type", "Traction") + word("Side Set", "right") + word("History", "Load") +
                                      numbers("Vector", plane ? std::vector{0.01, 0.} : std::vector{0.01, 0., 0.}))) +
            time_integrator("Newmark", 0.1, 1)),
      world());
}

/// A smooth field of the place.
inline Vector wave(const Model& model, double amplitude, double phase) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  Vector field(model.space().owned_map());
  const auto view = field.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < view.extent(0); ++i) {
    view(i, 0) = 0;
    for (std::size_t j = 0; j < d; ++j)
      view(i, 0) +=
          amplitude * std::sin(1.3 * mesh.coordinates[i / d * d + j] + phase + static_cast<double>(i % d + j));
  }
  return field;
}

/// `amplitude` along `axis` at all nodes.
inline Vector uniform(const Model& model, double amplitude, std::size_t axis) {
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  Vector field(model.space().owned_map());
  const auto view = field.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < view.extent(0); ++i) view(i, 0) = i % d == axis ? amplitude : 0.0;
  return field;
}

/// A copy as a vector of a Thyra space.
inline Teuchos::RCP<Thyra::VectorBase<double>> thyra(const Vector& x) {
  return Thyra::createVector<double, LocalId, GlobalId, Node>(Teuchos::rcp(new Vector(x, Teuchos::Copy)),
                                                              vector_space(x.getMap()));
}

inline Thyra::ModelEvaluatorBase::InArgs<double> arguments(const SemiDiscreteEvaluator& evaluator, const Vector& x,
                                                           const Vector& x_dot, const Vector& x_dot_dot, double t) {
  auto in = evaluator.createInArgs();
  in.set_x(thyra(x));
  in.set_x_dot(thyra(x_dot));
  in.set_x_dot_dot(thyra(x_dot_dot));
  in.set_t(t);
  in.set_W_x_dot_dot_coeff(0.0);
  return in;
}

/// |a - b| / |b|.
inline double relative_distance(const Thyra::VectorBase<double>& a, const Thyra::VectorBase<double>& b) {
  const auto difference = a.clone_v();
  Thyra::Vp_StV(difference.ptr(), -1.0, b);
  return Thyra::norm_2(*difference) / Thyra::norm_2(b);
}

/// The solvers of a list of a scene, completed for the model.
inline std::shared_ptr<const LinearSolverFactory> solvers(const Model& model, const Teuchos::ParameterList& list = {}) {
  return std::make_shared<LinearSolverFactory>(completed_linear_solver(list, problem_size(model)), &model);
}

/// A list with Belos, this preconditioner and operator.
inline Teuchos::ParameterList belos(const std::string& preconditioner, const std::string& op = "Assembled") {
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", "Belos").set("Preconditioner Type", preconditioner).set("Operator", op);
  return list;
}

/// A moving state of a held block, and an evaluator with reactions.
struct EvaluatorExample {
  explicit EvaluatorExample(int dimension = 2, const Teuchos::ParameterList& list = belos("MueLu"))
      : simulation(held_block(dimension)),
        model(simulation->model()),
        factory(solvers(model, list)),
        evaluator(model, factory, {"left"}),
        in(arguments(evaluator, wave(model, 0.02, 0), wave(model, 0.1, 1), wave(model, 0.3, 2), 0.5)) {
    in.set_W_x_dot_dot_coeff(40.0);
    in.set_alpha(2.0);
    in.set_beta(1.0);
  }
  /// The InArgs of a surface below the wall.
  Thyra::ModelEvaluatorBase::InArgs<double> inadmissible() const {
    Thyra::ModelEvaluatorBase::InArgs<double> result = in;
    result.set_x(thyra(uniform(model, -0.7, static_cast<std::size_t>(model.mesh().dimension) - 1)));
    return result;
  }

  std::unique_ptr<Simulation> simulation;
  const Model& model;
  std::shared_ptr<const LinearSolverFactory> factory;
  SemiDiscreteEvaluator evaluator;
  Thyra::ModelEvaluatorBase::InArgs<double> in;
};

}  // namespace ixos::test
