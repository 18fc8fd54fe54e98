/// Elasticity of one block.
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/symmetric_tensor.hpp"
#include "discretization/pattern.hpp"
#include "mesh/local_mesh.hpp"
#include "term/force_term.hpp"

namespace ixos {

class ElasticLaw;

/// The element's energy. All of them are functions of the displacement alone.
enum class Formulation {
  Standard,        ///< of displacements alone: locks if nearly incompressible, and in bending
  MeanDilatation,  ///< DilatationKernel: without the first, of all cell types
  Enhanced  ///< EnhancedKernel: without both if pressures are moderate; linear cells, enriched ones stay Standard
};

/// Means over the reference volume of each cell of one block, for output.
struct CellFields {
  std::vector<double> stress_invariant;  ///< tr(sigma)/E [-], E Young's modulus; see StateReport::cell_fields()
  std::vector<double> jacobian;          ///< J [-]
  std::vector<double> energy_density;    ///< stored by the law and by Maxwell branches [E0]
  std::vector<double> dissipated;        ///< by viscosity and branches since the start [E0]; empty without them
};

/// The elasticity of a block.
class Elasticity : public ForceTerm {
 public:
  Part part() const final { return Part::Elastic; }
  /// The factor of all moduli, 1 at first: stresses are proportional to it.
  std::vector<std::string> parameters() const final { return {"Modulus Factor"}; }
  bool add_parameter_derivative(std::size_t parameter, const Segment& segment, const Rule& rule,
                                double* f) const final {
    return add_factor_derivative(parameter, segment, rule, f);
  }
  /// Adds the diagonal of the tangent at segment.to to a local array.
  virtual void add_diagonal(const Segment& segment, double* diagonal) const = 0;
  /// Fills in the fields of the block.
  virtual void cell_fields(const double* u, CellFields& fields) const = 0;
  /// Sets, for each local cell of the block, the mean Cauchy stress over the reference volume [E0]. That of a block
  /// with mean dilatation is the stress of F~, that of an enhanced block includes the modes.
  virtual void cell_stress(const double* u, std::vector<SymmetricTensor>& stress) const = 0;
};

/// Returns whether the tangent of a block of that formulation can be applied without a matrix, by
/// ForceTerm::create_action(). Blocks of axisymmetric meshes cannot.
bool has_action(Formulation formulation);

/// Returns the term for one block, its cells in SIMD batches. The caller has checked the mesh (see check_cells).
/// `points`: Gauss points a direction of elements that are not enriched, see cell_rule(), 0 for the element's own
/// number; an enriched block gives its own number. Throws InputError for Enhanced quadratic cells. All but Standard
/// accept no rule with Mean::DiscreteGradient, nor do laws without a discrete gradient; Enhanced needs two points or
/// more.
std::unique_ptr<Elasticity> make_elastic_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                              const std::shared_ptr<const ElasticLaw>& law, int points = 0,
                                              Formulation formulation = Formulation::Standard);

}  // namespace ixos
