/// The semi-discrete model: M a + C v + f_v(u, v) + f_el(u) + f_c(u) = f_ext(t) with constrained degrees of freedom.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "discretization/discretization.hpp"
#include "model/constrained_entries.hpp"
#include "model/constraints.hpp"
#include "model/damping.hpp"
#include "model/loads.hpp"
#include "model/mass.hpp"
#include "model/material.hpp"
#include "term/elastic_term.hpp"
#include "term/interaction.hpp"
#include "term/viscous_term.hpp"

namespace ixos {

/// A term and its name, which several terms may share.
struct NamedTerm {
  std::string name;
  std::unique_ptr<Term> term;
  int account = -1;  ///< of Model::dissipation_names(); -1 if the term does not dissipate
};

/// The points that force terms keep of their last force; null for terms that keep nothing.
using KeptForces = std::vector<std::unique_ptr<KeptPoints>>;

struct NamedForceTerm {
  std::string name;
  const ForceTerm* term;
};

/// Quantities that the model stores and moves, summed over all ranks.
struct Momenta {
  double kinetic_energy = 0;
  std::vector<double> linear;   ///< D components; all are zero without inertia
  std::vector<double> angular;  ///< about the origin: z in 2D, x, y, z in 3D
};

/// The list of the terms that a scene or a program asked for. Absent terms allocate nothing. Local arrays hold owned
/// nodes, then ghosts; owned arrays hold the owned nodes only.
///
/// A program makes one from its own mesh in these steps; docs/embedding.md shows them:
/// - local_part() (mesh/local_mesh.hpp, mesh/distributed_mesh.hpp) makes the LocalMesh;
/// - materials take their laws from make_elastic_law();
/// - add_interaction() (model/surface_interaction.hpp) adds a wall; prescribe(), add_traction() and others
///   (model/conditions.hpp) add conditions and loads.
/// Then it reads what it needs at a displacement: energy(), interaction_report(), momenta(), force(), nodal_gap(),
/// contact_pressure(), cell_stress(). State::reaction of an integrator has the forces at prescribed degrees of freedom.
class Model {
 public:
  /// Throws InputError, with the block, if a block has no material or two, or a material has a value out of range.
  Model(LocalMesh mesh, const Comm& comm, const std::vector<Material>& materials,
        Inertia inertia = Inertia::Consistent);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  /// Adds an interaction of that name. A model that has interactions takes further ones after close(), too: nothing is
  /// kept for them (see force_and_keep).
  void add_interaction(std::unique_ptr<Interaction> term, const std::string& name = "interaction");
  Constraints& constraints() { return constraints_; }
  Loads& loads() { return loads_; }
  /// Ends the adding of interactions, constraints and loads: what is made of the model has arrays and solvers for those
  /// that it has. Integrators and evaluators call this, also of a model that several share. The functions of
  /// model/conditions.hpp and model/surface_interaction.hpp, Constraints::add() and Loads::add() then throw
  /// std::logic_error.
  void close() const {
    closed_ = true;
    constraints_.close();
    loads_.close();
  }
  /// Throws std::logic_error after close().
  void check_open() const;

  const LocalMesh& mesh() const { return mesh_; }
  const DofSpace& space() const { return space_; }
  const Pattern& pattern() const { return pattern_; }
  const Discretization& discretization() const { return discretization_; }
  /// Couples further nodes, see Discretization::couple. Integrators renew their solvers at the next step. Collective.
  void couple(const std::vector<std::vector<int>>& stencils);
  const Mass* mass() const { return mass_.get(); }     ///< null if static
  const Damping* damping() const { return damping_; }  ///< null without Rayleigh damping
  /// Returns the materials that the model was made with.
  const std::vector<Material>& materials() const { return materials_; }
  const Constraints& constraints() const { return constraints_; }
  const Loads& loads() const { return loads_; }
  bool has_interactions() const { return !interactions_.empty(); }
  /// Returns the mean diagonal entry of the elastic stiffness at rest, and of the mass (0 if static), over all ranks.
  double elastic_scale() const { return elastic_scale_; }
  double mass_scale() const { return mass_scale_; }
  /// Returns the largest K_ii/M_ii at rest [1/T0^2]; 0 without inertia.
  double stiffest() const { return stiffest_; }

  /// Returns the elastic terms, named after their blocks, and the interactions.
  const std::vector<NamedForceTerm>& force_terms() const { return force_terms_; }
  /// Tell all terms of the steps, see Term.
  void initialize();
  void begin_step(const KnownState& start, double time, double dt);
  void begin_stage(const StageStart& start);
  /// Returns the work that the step dissipated, parallel to dissipation_names() [E0 L0^D]. Collective if there are any.
  std::vector<double> accept(const AcceptedStep& step);
  /// Collective.
  void transfer(Record& record);
  /// Returns the names of what dissipates, equal on all ranks.
  const std::vector<std::string>& dissipation_names() const { return dissipation_names_; }
  /// Returns whether the forces of all terms of that part are gradients for the rule, so that its tangent is symmetric.
  bool is_gradient(Part part, const Rule& rule) const;

  /// Sets f to the rule's force of that part's terms; f is local and overwritten. Returns false if the state is
  /// inadmissible on this rank.
  bool force(Part part, const Segment& segment, const Rule& rule, double* f) const;
  /// Returns a place for what force_and_keep() keeps, parallel to force_terms().
  KeptForces create_kept() const;
  /// See ForceTerm::add_force_and_keep, add_kept_tangent.
  bool force_and_keep(Part part, const Segment& segment, const Rule& rule, KeptForces& kept, double* f) const;
  void add_kept_tangent(Part part, const Segment& segment, const Rule& rule, Tangent kind, const KeptForces& kept,
                        double* values) const;

  /// Call the RateTerm functions of these names for all rate terms. Without rate terms they do nothing.
  bool has_rates() const { return !rates_.empty(); }
  bool rates_are_gradients(RateForm form) const;
  void add_rate_force(const double* u, double* f) const;
  void add_rate_tangent(const double* u, double* values) const;
  double local_rate_potential(const double* u) const;
  void add_rate_force_at(double factor, const double* u, const double* v, double* f) const;
  void add_rate_tangent_at(double by_velocity, double by_displacement, const double* u, const double* v,
                           double* values) const;
  void add_rate_row_sums(const double* u, double* sums) const;
  /// Returns whether some block has a viscosity.
  bool has_viscosity() const { return largest_viscosity() > 0; }
  /// Returns the largest viscosity of a block [T0].
  double largest_viscosity() const;

  /// Adds the part's tangent. `kind` concerns interactions only.
  void add_tangent(Part part, const Segment& segment, const Rule& rule, Tangent kind, double* values) const;
  /// Returns an action of each term of the part; null if a term offers none.
  std::vector<std::unique_ptr<TangentAction>> actions(Part part) const;
  /// Returns, for each elastic term, its share of mass M + damping C.
  std::vector<LinearPart> linear_parts(double mass, double damping) const;
  /// Keeps no matrix beyond the pattern's: for tangents that are applied from actions. See Damping::do_without_matrix.
  void do_without_matrices();
  /// See ForceTerm::add_row_sums.
  bool add_row_sums(Part part, const Segment& segment, double* sums) const;
  /// Returns the largest admissible step along `direction`, over all interactions and ranks. Collective.
  double admissible_step(const Segment& segment, const Rule& interaction, const double* direction) const;

  /// Returns the part's potential energy [E0 L0^D]: this rank's share, or the sum over all ranks (collective).
  double local_energy(Part part, const double* u) const;
  double energy(Part part, const double* u) const;
  /// Returns the gradient of the part's energy by u [E0 L0^(D-1)]: a local array, valid for owned nodes, all NaN if the
  /// state is inadmissible on this rank. The forces on the body are minus these. Not collective.
  std::vector<double> nodal_force(Part part, const double* u) const;
  /// Returns this rank's sum of Interaction::mean_potential over the interactions.
  double local_mean_potential(const Segment& segment) const;
  /// Returns the largest Interaction::gap_ratio. Collective.
  double gap_ratio(const double* from, const double* to) const;
  /// Returns this rank's sum of Interaction::rounding over the interactions.
  double local_rounding(const double* u) const;
  /// Return sums over all ranks. Collective.
  InteractionReport interaction_report(const double* u) const;
  Momenta momenta(const double* u, const double* v) const;

  /// Returns the fields by block, local cells. Not collective.
  std::vector<CellFields> cell_fields(const double* u) const;
  /// Returns the traction of all interactions on the bodies, their nodal force over int N_a dA: a local array, valid
  /// for owned nodes, zero away from interacting surfaces and at derivative nodes [E0]. Not collective.
  std::vector<double> interaction_traction(const double* u) const;
  /// Returns the mean Cauchy stress over each cell's reference volume, by block and local cell: that of elasticity and
  /// of Kelvin-Voigt viscosity, without Rayleigh damping [E0]. Not collective.
  std::vector<std::vector<SymmetricTensor>> cell_stress(const double* u, const double* v) const;
  /// Returns, by local node and valid for owned nodes, the gap to the nearest obstacle of an interaction [L0]; NaN away
  /// from interacting surfaces. Derivative nodes have the gap's derivative. Not collective.
  std::vector<double> nodal_gap(const double* u) const;
  /// Returns, by local node and valid for owned nodes, the traction of all interactions along the obstacles' normals,
  /// int N_a T dA over int N_a dA: positive where an obstacle pushes; zero away from interacting surfaces and at
  /// derivative nodes [E0]. Not collective.
  std::vector<double> contact_pressure(const double* u) const;

  /// Sets result[r] = sum of K_rp x_p over constrained columns p, for free owned rows r, 0 for constrained ones; K in
  /// the layout of Pattern::create_matrix, x local.
  void multiply_constrained_columns(const double* values, const double* x, double* result) const;
  void add_to_diagonal(double value, double* values) const;
  /// Replaces the rows and columns of constrained degrees of freedom in the matrix values by `diagonal` I.
  void constrain_matrix(double diagonal, double* values) const;

 private:
  void add_block(std::size_t number, const Material& material);
  void add_damping(const LocalBlock& block, const Material& material, const Elasticity& term);
  void add_rate_term(std::unique_ptr<RateTerm> term, const std::string& name);
  void add_term(std::unique_ptr<Term> term, const std::string& name);
  void find_scales();
  const ConstrainedEntries& constrained_entries() const;
  /// Returns int N_a dA by local node over all interacting surfaces; a side of several interactions counts once.
  const std::vector<double>& surface_measure() const;
  template <class Visit>
  void for_each(Part part, const Visit& visit) const;

  const std::vector<Material> materials_;
  Discretization discretization_;
  const LocalMesh& mesh_;
  const DofSpace& space_;
  const Pattern& pattern_;
  std::unique_ptr<Mass> mass_;
  std::vector<NamedTerm> terms_;
  struct Body {
    const Elasticity* term;
    const Viscosity* viscosity;  ///< may be null
    std::size_t block;
    Material material;
  };
  std::vector<Body> bodies_;                      ///< blocks and their terms
  std::vector<NamedForceTerm> force_terms_;       ///< the force terms among them
  std::vector<const Interaction*> interactions_;  ///< the interactions among the terms
  std::vector<const RateTerm*> rates_;            ///< the rate terms among them
  Damping* damping_ = nullptr;                    ///< one of the rate terms
  std::vector<std::string> dissipation_names_;
  Constraints constraints_;
  mutable std::unique_ptr<ConstrainedEntries> constrained_entries_;  ///< made at the first use
  mutable std::vector<double> surface_measure_;                      ///< made at the first use
  Loads loads_;
  mutable bool closed_ = false;
  double elastic_scale_ = 0;
  double mass_scale_ = 0;
  double stiffest_ = 0;
};

}  // namespace ixos
