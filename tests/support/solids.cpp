#include "support/solids.hpp"

#include "mesh/partition.hpp"
#include "support/scene_text.hpp"

namespace ixos::test {

std::unique_ptr<Model> model_of(const Mesh& mesh, Material material, Inertia inertia) {
  const Comm comm = world();
  const int ranks = comm->getSize();
  material.block = "body";
  return std::make_unique<Model>(localize(mesh, partition_nodes(mesh, ranks), comm->getRank(), ranks), comm,
                                 std::vector<Material>{material}, inertia);
}

Material elastic(ElasticLawOfConstants law, double nu) {
  Material material;
  material.law = law(lame_constants(1, nu));
  material.density = 1;
  return material;
}

std::vector<double> at_rest(const Model& model) {
  return std::vector<double>(static_cast<std::size_t>(model.space().local()), 0.0);
}

Integrator direct(Model& model, const Table& table, double tolerance) {
  Teuchos::ParameterList linear;
  linear.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  return {model, table, std::make_shared<LinearSolverFactory>(linear), NewtonOptions{tolerance, 100, {}}};
}

}  // namespace ixos::test
