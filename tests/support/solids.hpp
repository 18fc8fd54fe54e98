/// Models of one material for tests, built without a scene.
#pragma once
#include <memory>
#include <vector>

#include "mesh/enrichment/enrich.hpp"
#include "model/model.hpp"
#include "time/integrator.hpp"

namespace ixos::test {

/// The mesh, all of its block "body" of this material, on all ranks.
std::unique_ptr<Model> model_of(const Mesh& mesh, Material material, Inertia inertia);

/// A function like neo_hooke() or linear_elastic().
using ElasticLawOfConstants = std::shared_ptr<const ElasticLaw> (*)(const Lame&);

/// A neo-Hookean box of 2 by 1 (by 1) L0 above y = 0 (2D) or z = 0 (3D), without inertia; its bottom has the contact
/// element.
std::unique_ptr<Model> box_with_contact(int dimension, ContactElement element);

/// E = 1, density 1.
Material elastic(ElasticLawOfConstants law, double nu);

/// No displacement, or no velocity: a local array of zeros.
std::vector<double> at_rest(const Model& model);

/// A smooth displacement that derivative nodes share in, and numbers without order; local arrays, the same on every
/// rank.
std::vector<double> smooth_field(const Model& model, double size);
std::vector<double> noise(const Model& model, double size);

/// With the direct solver; the tolerance is Newton's.
Integrator direct(Model& model, const Table& table, double tolerance = NewtonOptions().tolerance);

}  // namespace ixos::test
