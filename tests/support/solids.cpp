#include "support/solids.hpp"

#include <cmath>

#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "support/contact_element.hpp"
#include "support/scene_text.hpp"

namespace ixos::test {

std::unique_ptr<Model> model_of(const Mesh& mesh, Material material, Inertia inertia) {
  const Comm comm = world();
  const int ranks = comm->getSize();
  material.block = "body";
  return std::make_unique<Model>(localize(mesh, partition_nodes(mesh, ranks), comm->getRank(), ranks), comm,
                                 std::vector<Material>{material}, inertia);
}

std::unique_ptr<Model> box_with_contact(int dimension, ContactElement element) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {2, 1, 1};
  shape.divisions = {3, 2, 2};
  shape.lower = {-1, dimension == 2 ? 0.3 : -0.5, 0.3};
  Mesh mesh = box(shape);
  give_contact_element(mesh, "bottom", element);
  return model_of(mesh, elastic(neo_hooke, 0.3), Inertia::None);
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

std::vector<double> smooth_field(const Model& model, double size) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> u(mesh.coordinates.size());
  for (std::size_t k = 0; k < u.size(); ++k) {
    const std::size_t node = k / d;
    const double x = mesh.coordinates[node * d], y = mesh.coordinates[node * d + 1];
    u[k] = mesh.is_derivative(node) ? 0.1 * size * std::sin(double(k % d) + x)
                                    : size * std::sin(1.3 * x + 0.7 * y + double(k % d));
  }
  return u;
}

std::vector<double> noise(const Model& model, double size) {
  std::vector<double> u = at_rest(model);
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = size * std::sin(0.3 + 1.7 * model.mesh().original_ids[i / d] + 0.9 * static_cast<double>(i % d));
  return u;
}

Integrator direct(Model& model, const Table& table, double tolerance) {
  Teuchos::ParameterList linear;
  linear.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  return {model, table, std::make_shared<LinearSolverFactory>(linear), NewtonOptions{tolerance, 100, {}}};
}

}  // namespace ixos::test
