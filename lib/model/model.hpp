/// The semi-discrete model: M a + C v + f_el(u) + f_c(u) = 0 with constrained degrees of freedom.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/damping.hpp"
#include "model/elastic_term.hpp"
#include "model/mass.hpp"
#include "model/term.hpp"

namespace ixos {

/// The material of one block.
struct Material {
  std::string block;
  ElasticLaw law = ElasticLaw::NeoHooke;
  Lame lame{};
  double density = 0;            ///< [E0 T0^2/L0^2]
  double mass_damping = 0;       ///< alpha_1 [1/T0]
  double stiffness_damping = 0;  ///< alpha_2 [T0]
};

/// A prescribed degree of freedom, u(t) = displacement + velocity t.
struct Constraint {
  int dof;              ///< local number; ghosts are constrained on every rank that sees them
  double displacement;  ///< [L0]
  double velocity;      ///< [L0/T0]
};

/// A sum over all ranks of what the model stores and moves.
struct Momenta {
  double kinetic_energy = 0;
  std::vector<double> linear;   ///< D components
  std::vector<double> angular;  ///< about the origin: z in 2D, x, y, z in 3D
};

/// The loop over the terms that a scene asked for. What is absent is not allocated. Local arrays hold owned nodes, then
/// ghosts; owned arrays the owned nodes only.
class Model {
 public:
  Model(LocalMesh mesh, const Comm& comm, const std::vector<Material>& materials);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  /// Interactions and constraints are added before the model is given to an integrator or an evaluator.
  void add_interaction(std::unique_ptr<Term> term) { interactions_.push_back(std::move(term)); }
  void add_constraint(const Constraint& constraint) { constraints_.push_back(constraint); }

  const LocalMesh& mesh() const { return mesh_; }
  const DofSpace& space() const { return space_; }
  const Pattern& pattern() const { return pattern_; }
  const Mass& mass() const { return mass_; }
  const Damping* damping() const { return damping_.get(); }
  const std::vector<Constraint>& constraints() const { return constraints_; }
  bool has_interactions() const { return !interactions_.empty(); }
  /// Mean diagonal entry of the elastic stiffness at rest, and of the mass, over all ranks.
  double elastic_scale() const { return elastic_scale_; }
  double mass_scale() const { return mass_scale_; }

  /// f = the rule's force of the elastic (interaction) terms, f local and overwritten. False where inadmissible on this
  /// rank.
  bool elastic_force(const Segment& segment, const Rule& rule, double* f) const;
  bool interaction_force(const Segment& segment, const Rule& rule, double* f) const;
  void add_elastic_tangent(const Segment& segment, const Rule& rule, double* values) const;
  void add_interaction_tangent(const Segment& segment, const Rule& rule, double* values) const;
  /// Largest admissible step along `direction`, over all interactions and ranks. Collective.
  double admissible_step(const Segment& segment, const Rule& interaction, const double* direction) const;

  /// Collective sums over all ranks [E0 L0^D].
  double elastic_energy(const double* u) const;
  double interaction_energy(const double* u) const;
  InteractionReport interaction_report(const double* u) const;
  Momenta momenta(const double* u, const double* v) const;

  /// By block, local cells. Not collective.
  std::vector<CellFields> cell_fields(const double* u) const;
  /// Traction of all interactions on the bodies, their nodal force over int N_a dA: local array, valid for owned nodes,
  /// zero away from interacting surfaces [E0]. Not collective.
  std::vector<double> interaction_traction(const double* u) const;

  /// values = matrix values with the rows and columns of constrained degrees of freedom replaced by `diagonal` I.
  void constrain_matrix(double diagonal, double* values) const;

 private:
  double elastic_trace() const;

  LocalMesh mesh_;
  DofSpace space_;
  Pattern pattern_;
  Mass mass_;
  std::unique_ptr<Damping> damping_;
  std::vector<std::unique_ptr<Term>> elastic_;
  std::vector<std::size_t> elastic_block_;  ///< of each elastic term
  std::vector<std::unique_ptr<Term>> interactions_;
  std::vector<Constraint> constraints_;
  double elastic_scale_ = 0;
  double mass_scale_ = 0;
};

}  // namespace ixos
