/// The semi-discrete model: M a + C v + f_v(u, v) + f_el(u) + f_c(u) = f_ext(t) with constrained degrees of freedom.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "discretization/discretization.hpp"
#include "model/constrained_entries.hpp"
#include "model/constraints.hpp"
#include "model/damping.hpp"
#include "model/grip.hpp"
#include "model/interaction_group.hpp"
#include "model/loads.hpp"
#include "model/mass.hpp"
#include "model/material.hpp"
#include "model/springs.hpp"
#include "term/elastic_term.hpp"
#include "term/interaction.hpp"
#include "term/maxwell_term.hpp"
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

/// The stress of one body with Maxwell branches after a step: roots of integrals over the reference volume of squares
/// at small strains [E0 L0^(D/2)].
struct HistoryStress {
  HistoryUpdate update = HistoryUpdate::BackwardEuler;
  std::vector<double> times;     ///< of relaxation, by branch [T0]
  std::vector<double> branches;  ///< of each branch
  double sum = 0;                ///< of all branches
  double all = 0;                ///< of the branches and the deviator of the elastic law: a bound
};

/// Quantities that the model stores and moves, summed over all ranks.
struct Momenta {
  double kinetic_energy = 0;
  std::vector<double> linear;   ///< all are zero without inertia; of an axisymmetric mesh the first, too
  std::vector<double> angular;  ///< about the origin: z in 2D, x, y, z in 3D; zero of an axisymmetric mesh
};

/// The list of the terms that a scene or a program asked for. Absent terms allocate nothing. Local arrays hold owned
/// nodes, then ghosts; owned arrays hold the owned nodes only.
///
/// Energies, forces and masses of an axisymmetric mesh are those of the whole body, D = 3 in their units: the force at
/// a node is that on its ring. A radial force is summed around the ring, it is no component of a vector. Nodes on the
/// axis are held there.
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

  /// Adds an interaction of that name. The energy that it dissipates counts as "friction of <name>" or "damage of
  /// <name>", or else under the name. A model that has interactions takes further ones after close(), too: nothing is
  /// kept for them (see force_and_keep).
  void add_interaction(std::unique_ptr<Interaction> term, const std::string& name = "interaction");
  /// Adds a grip, whose constraints and driving loads the model has already; the model takes its springs and dashpots,
  /// each may be null. grip_rigidly() and grip_elastically() (model/grips.hpp) call this.
  void add_grip(Grip grip, std::unique_ptr<Springs> springs, std::unique_ptr<Dashpots> dashpots);
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
  /// Couples the nodes that interactions of bodies couple near the displacement u, a local array, if they have changed
  /// (see Interaction::update_stencils). Collective if couples_anew().
  void update_couplings(const double* u);
  /// Returns whether some interaction couples other nodes as bodies move. Equal on all ranks.
  bool couples_anew() const { return !moving_.empty(); }
  const Mass* mass() const { return mass_.get(); }     ///< null if static
  const Damping* damping() const { return damping_; }  ///< null without Rayleigh damping
  /// Returns the materials that the model was made with.
  const std::vector<Material>& materials() const { return materials_; }
  const Constraints& constraints() const { return constraints_; }
  const Loads& loads() const { return loads_; }
  bool has_interactions() const { return !interactions_.empty(); }
  /// Returns the names of the interactions, each once, equal on all ranks.
  std::vector<std::string> interaction_names() const;
  /// Returns the interaction of that name alone; the reference is valid until the next add_interaction(). Throws
  /// InputError that names the nearest name if there is none.
  const InteractionGroup& interaction(const std::string& name) const;
  /// Returns whether some interaction has an obstacle that is moved. Equal on all ranks.
  bool has_moved_obstacles() const;
  /// Returns whether all obstacles have a place and a velocity at `time`. Equal on all ranks.
  bool obstacles_are_finite(double time) const;
  /// Returns whether some interaction's law is defined at every gap. Equal on all ranks.
  bool has_laws_of_every_gap() const;
  const std::vector<Grip>& grips() const { return grips_; }
  /// Returns whether some grip has springs or dashpots.
  bool has_springs() const;
  /// Returns the mean diagonal entry of the elastic stiffness at rest, and of the mass (0 if static), over all ranks.
  double elastic_scale() const { return elastic_scale_; }
  double mass_scale() const { return mass_scale_; }
  /// Returns the largest K_ii/M_ii at rest [1/T0^2]; 0 without inertia.
  double stiffest() const { return stiffest_; }

  /// Returns the elastic terms, named after their blocks, the springs of grips, and the interactions.
  const std::vector<NamedForceTerm>& force_terms() const { return force_terms_; }
  /// Tell all terms of the steps, see Term.
  void initialize(const KnownState& start);
  void begin_step(const KnownState& start, double time, double dt);
  void begin_stage(const StageStart& start);
  /// Returns the work that the step dissipated, parallel to dissipation_names() [E0 L0^D]. Collective if there are any.
  std::vector<double> accept(const AcceptedStep& step);
  /// Transfers what the terms keep, and the part of it on which forces depend, as far as the record has it. Throw
  /// InputError, on all ranks, if it does not fit the terms. Collective.
  void transfer(Record& record);
  void transfer_histories(Record& record);
  /// Returns the local error of a step that comes from the histories of Maxwell branches, as a displacement [L0]: the
  /// root mean square, over the bodies with branches, of the error of stress over the shear modulus at once, times the
  /// longest side of the box around the mesh. 0 without branches. Collective.
  double history_error(const double* from, const double* to, double dt) const;
  /// Returns the stress of each body with Maxwell branches after the step that was accepted last. Collective if there
  /// are any.
  std::vector<HistoryStress> history_stresses() const;
  /// Returns whether the forces of some term depend on what it keeps, see Term::has_history(). Equal on all ranks.
  bool has_histories() const;
  /// Returns the names of what dissipates, equal on all ranks.
  const std::vector<std::string>& dissipation_names() const { return dissipation_names_; }
  /// Sets the time of the states on which functions of a displacement alone report: energies, reports, gaps, nodal
  /// forces and fields. Only moved obstacles depend on it. Integrators set it to their own time.
  void set_time(double time) const;
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
  /// Returns whether some block has Maxwell branches.
  bool has_viscoelasticity() const;
  /// Returns the largest viscosity of a block [T0].
  double largest_viscosity() const;

  /// Adds the part's tangent. `kind` concerns interactions only.
  void add_tangent(Part part, const Segment& segment, const Rule& rule, Tangent kind, double* values) const;
  /// Returns an action of each term of the part; null if a term offers none.
  std::vector<std::unique_ptr<TangentAction>> actions(Part part) const;
  /// Returns, for the elastic term of each block, its share of mass M + damping C.
  std::vector<LinearPart> linear_parts(double mass, double damping) const;
  /// Keeps no matrix beyond the pattern's: for tangents that are applied from actions. See Damping::do_without_matrix.
  void do_without_matrices();
  /// See ForceTerm::add_row_sums.
  bool add_row_sums(Part part, const Segment& segment, double* sums) const;
  /// Returns the largest admissible step along `direction`, over all interactions and ranks. Collective.
  double admissible_step(const Segment& segment, const Rule& interaction, const double* direction) const;

  /// Returns this rank's sum of ForceTerm::potential over that part's terms, except interactions that follow a mean in
  /// closed form in place of the rule's points [E0 L0^D].
  double local_potential(Part part, const Rule& rule, const double* u) const;
  /// Returns the part's potential energy [E0 L0^D]: this rank's share, or the sum over all ranks (collective).
  double local_energy(Part part, const double* u) const;
  double energy(Part part, const double* u) const;
  /// Returns the energy of elasticity and of the springs of grips, whose driven ends are where they are at `time`; in
  /// energy(Part::Elastic, u) they rest in their first places [E0 L0^D]. Collective.
  double elastic_energy(double time, const double* u) const;
  /// Adds the gradient of elastic_energy(time, u) by u, less that of energy(Part::Elastic, u), to a local array; valid
  /// for owned nodes [E0 L0^(D-1)]. Not collective.
  void add_stretch_gradient(double time, double* f) const;
  /// Returns the work of the driven ends of springs and dashpots in the accepted step, less that of their loads [E0
  /// L0^D]. Collective.
  double grip_work() const;
  /// Returns the sum of Interaction::obstacle_work() [E0 L0^D]. Collective.
  double obstacle_work(const Segment& segment, const Rule& rule) const;
  /// Returns the gradient of the part's energy by u [E0 L0^(D-1)]: a local array, valid for owned nodes, all NaN if the
  /// state is inadmissible on this rank. The forces on the body are minus these. Not collective.
  std::vector<double> nodal_force(Part part, const double* u) const;
  /// Returns this rank's sum of Interaction::mean_potential over the interactions that follow the exact mean, by that
  /// rule or in place of it [E0 L0^D].
  double local_mean_potential(const Segment& segment, const Rule& rule) const;
  /// Returns the largest Interaction::gap_ratio. Collective.
  double gap_ratio(const double* from, const double* to) const;
  /// Returns whether some interaction has friction, whose force has kinks.
  bool has_friction() const;
  /// Returns this rank's sum of Interaction::rounding over the interactions.
  double local_rounding(const double* u) const;
  /// Return sums over all ranks. Collective.
  InteractionReport interaction_report(const double* u) const;
  Momenta momenta(const double* u, const double* v) const;

  /// Returns the fields by block, local cells. Not collective. `v`: null, or the velocity: the stress invariant is then
  /// that of cell_stress(), else that of the elastic law alone.
  std::vector<CellFields> cell_fields(const double* u, const double* v = nullptr) const;
  /// Returns the traction of all interactions on the bodies, their nodal force over int N_a dA: a local array, valid
  /// for owned nodes, zero away from interacting surfaces and at derivative nodes [E0]. Not collective.
  std::vector<double> interaction_traction(const double* u) const;
  /// Returns the mean Cauchy stress over each cell's reference volume, by block and local cell: that of elasticity,
  /// of Kelvin-Voigt viscosity and of Maxwell branches, without Rayleigh damping [E0]. Not collective.
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
  void add_branches();
  void place_terms();
  void add_rate_term(std::unique_ptr<RateTerm> term, const std::string& name);
  void add_term(std::unique_ptr<Term> term, const std::string& name);
  void transfer(std::size_t term, Record& record);
  std::string section_of(std::size_t term) const;
  void find_scales();
  const ConstrainedEntries& constrained_entries() const;
  const InteractionGroup& all_interactions() const;
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
    const Viscosity* viscosity;              ///< may be null
    const Viscoelasticity* viscoelasticity;  ///< may be null
    std::size_t block;
    Material material;
  };
  /// Adds the stress of viscosity and of Maxwell branches by local cell of a block.
  static void add_inelastic_stress(const Body& body, const double* u, const double* v,
                                   std::vector<SymmetricTensor>& stress);
  std::vector<Body> bodies_;                      ///< blocks and their terms
  std::vector<NamedForceTerm> force_terms_;       ///< the force terms among them
  std::vector<const Interaction*> interactions_;  ///< the interactions among the terms
  std::vector<Interaction*> moving_;              ///< those that couple other nodes as bodies move
  std::vector<const RateTerm*> rates_;            ///< the rate terms among them
  Damping* damping_ = nullptr;                    ///< one of the rate terms
  std::vector<std::string> dissipation_names_;
  Constraints constraints_;
  mutable std::unique_ptr<ConstrainedEntries> constrained_entries_;  ///< made at the first use
  std::vector<std::string> interaction_of_;  ///< the names of interactions_, which several may share
  Loads loads_;
  mutable bool closed_ = false;
  double elastic_scale_ = 0;
  double mass_scale_ = 0;
  double stiffest_ = 0;
  std::vector<Grip> grips_;
  mutable std::unique_ptr<InteractionGroup> all_interactions_;           ///< made at the first use
  mutable std::map<std::string, InteractionGroup> single_interactions_;  ///< each made at its first use
  mutable double time_ = 0;                                              ///< of set_time()
};

}  // namespace ixos
