/// Models of one material for tests, built without a scene.
#pragma once
#include <memory>
#include <vector>

#include "model/model.hpp"
#include "time/integrator.hpp"

namespace ixos::test {

/// The mesh, all of its block "body" of this material, on all ranks.
std::unique_ptr<Model> model_of(const Mesh& mesh, Material material, Inertia inertia);

/// A function like neo_hooke() or linear_elastic().
using ElasticLawOfConstants = std::shared_ptr<const ElasticLaw> (*)(const Lame&);

/// E = 1, density 1.
Material elastic(ElasticLawOfConstants law, double nu);

/// No displacement, or no velocity: a local array of zeros.
std::vector<double> at_rest(const Model& model);

/// With the direct solver; the tolerance is Newton's.
Integrator direct(Model& model, const Table& table, double tolerance = NewtonOptions().tolerance);

}  // namespace ixos::test
