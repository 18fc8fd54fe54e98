/// The semi-discrete model: M a + C v + f_v(u, v) + f_el(u) + f_c(u) = f_ext(t) with constrained degrees of freedom.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "discretization/discretization.hpp"
#include "model/body.hpp"
#include "model/carried_nodes.hpp"
#include "model/grip.hpp"
#include "model/tied_sets.hpp"
#include "rigid/rigid_bodies.hpp"
#include "term/body/damping.hpp"
#include "term/body/mass.hpp"
#include "term/interaction.hpp"
#include "term/rate_term.hpp"
#include "term/support/constrained_entries.hpp"
#include "term/support/constraints.hpp"
#include "term/support/loads.hpp"

namespace ixos {

class Dashpots;
class Springs;

/// A term and its name, which several terms may share.
struct NamedTerm {
  std::string name;
  std::unique_ptr<Term> term;
  int account = -1;  ///< of Model::dissipation_names(); -1 if the term does not dissipate
};

struct NamedForceTerm {
  std::string name;
  const ForceTerm* term;
};

struct NamedInteraction {
  std::string name;
  Interaction* term;
};

/// A number of a rigid body that moves by a history: a translation.
struct DrivenGlobal {
  std::size_t place;  ///< in local arrays
  std::shared_ptr<const TimeFunction> motion;
};

/// Numbers that tell how stiff and how heavy a model is, over all ranks.
struct ModelScales {
  double elastic = 0;   ///< mean diagonal entry of the elastic stiffness at rest
  double mass = 0;      ///< mean diagonal entry of the mass; 0 if static
  double stiffest = 0;  ///< largest K_ii/M_ii at rest [1/T0^2]; 0 without inertia
};

/// The work of a step over all ranks [E0 L0^D].
struct ModelWork {
  std::vector<double> dissipated;  ///< parallel to Model::dissipation_names()
  double driven = 0;               ///< of driven ends of springs and dashpots, less that of their loads
};

/// A part of a mesh with its unknowns and its communicator, and the list of the terms that a scene or a program asked
/// for. Absent terms allocate nothing. It holds no state of a motion: that is a State, an argument. Sums over the terms
/// stand in balance/, what a state looks like in model/state_report.hpp. Local arrays hold owned nodes, then ghosts;
/// owned arrays hold the owned nodes only.
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
/// Then it reads what it needs in a state: StateReport. State::reaction of an integrator has the forces at prescribed
/// degrees of freedom.
class Model {
 public:
  /// Throws InputError, with the block, if a block has no material or two, or a material has a value out of range.
  /// The rigid bodies carry obstacles, see SurfaceInteraction.
  Model(LocalMesh mesh, const Comm& comm, const std::vector<Material>& materials, Inertia inertia = Inertia::Consistent,
        RigidBodies rigid_bodies = {});
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  // Its parts.

  /// Adds an interaction of that name. The energy that it dissipates counts as "friction of <name>" or "damage of
  /// <name>", or else under the name. A model that has interactions takes further ones after close(), too: no force of
  /// them is kept for its tangent (see TermSums::force_and_keep).
  void add_interaction(std::unique_ptr<Interaction> term, const std::string& name = "interaction");
  /// Adds a grip, whose constraints and driving loads the model has already; the model takes its springs and dashpots,
  /// each may be null. grip_rigidly() and grip_elastically() (model/grips.hpp) call this.
  void add_grip(Grip grip, std::unique_ptr<Springs> springs, std::unique_ptr<Dashpots> dashpots);
  /// Adds springs and dashpots of what is no node; each may be null. support_body() (model/body_supports.hpp) calls
  /// this.
  void add_supports(const std::string& name, std::unique_ptr<Springs> springs, std::unique_ptr<Dashpots> dashpots);
  /// Moves a held translation of a rigid body by a history, displacement [L0]. Throws std::out_of_range for a direction
  /// that is not 0 to 2, InputError if the body moves freely along it.
  void drive_body(std::size_t body, std::size_t direction, std::shared_ptr<const TimeFunction> motion);
  /// Has a rigid body carry nodes, which are local, ghosts included. Throws InputError, on this rank, if one is tied,
  /// or a condition holds it.
  void carry_nodes(std::size_t body, const std::vector<int>& nodes);
  Constraints& constraints() { return constraints_; }
  Loads& loads() { return loads_; }
  TiedConditions& tied_conditions() { return tied_conditions_; }
  /// Ends the adding of interactions, constraints and loads: what is made of the model has arrays and solvers for those
  /// that it has. Integrators and evaluators call this, also of a model that several share. The functions of
  /// model/conditions.hpp and model/surface_interaction.hpp, Constraints::add() and Loads::add() then throw
  /// std::logic_error. Throws it if a tied node is constrained, whose masters move it, and what check_tied_conditions()
  /// throws.
  void close() const;
  /// Throws InputError if a condition names a tied node, and none holds a node that it follows likewise, see
  /// TiedConditions. Collective if the mesh has ties.
  void check_tied_conditions() const { tied_conditions_.check(mesh(), space().comm()); }
  /// Throws std::logic_error after close().
  void check_open() const;

  const LocalMesh& mesh() const { return discretization_.mesh(); }
  const DofSpace& space() const { return discretization_.space(); }
  const Pattern& pattern() const { return discretization_.pattern(); }
  const Discretization& discretization() const { return discretization_; }
  /// Couples further nodes, see Discretization::couple. Integrators renew their solvers at the next step. Collective.
  void couple(const std::vector<std::vector<int>>& stencils);
  /// Couples the nodes that interactions of bodies couple near the displacement u, a local array, if they have changed
  /// (see Coupling). Collective if couples_anew().
  void update_couplings(const double* u);
  /// Returns whether some interaction couples other nodes as bodies move. Equal on all ranks.
  bool couples_anew() const { return !couplings_.empty(); }

  const Mass* mass() const { return mass_.get(); }     ///< null if static
  const Damping* damping() const { return damping_; }  ///< null without Rayleigh damping
  /// Keeps no matrix beyond the pattern's: for tangents that are applied from actions. See Damping::do_without_matrix.
  void do_without_matrices();
  const Constraints& constraints() const { return constraints_; }
  const Loads& loads() const { return loads_; }
  /// Puts what constraints prescribe at `time` into local arrays, see Constraints::set(), removes what leaves the
  /// planes of nodes, and interpolates tied nodes.
  void set_prescribed(double time, double* u, double* v, double* a) const;
  /// Returns the materials that the model was made with.
  const std::vector<Material>& materials() const { return materials_; }
  const std::vector<Body>& bodies() const { return bodies_; }
  const std::vector<Grip>& grips() const { return grips_; }
  /// Returns the springs of grips and of rigid bodies, and whether there are springs or dashpots. Equal on all ranks.
  const std::vector<const Springs*>& springs() const { return springs_; }
  bool has_supports() const { return has_supports_; }
  /// Returns the rigid bodies; their numbers stand at the end of local arrays, from DofSpace::first_global() on.
  const RigidBodies& rigid_bodies() const { return rigid_bodies_; }
  /// Returns the place of a body's first number in local arrays.
  std::size_t first_number(std::size_t body) const {
    return static_cast<std::size_t>(space().first_global()) + RigidBodies::first(body);
  }
  /// Returns the numbers that move by histories; none of bodies that are prescribed as a whole.
  const std::vector<DrivenGlobal>& driven_globals() const { return driven_globals_; }
  /// Returns the nodes that bodies carry; the length is equal on all ranks.
  const std::vector<CarriedNodes>& carried_nodes() const { return carried_nodes_; }
  /// Sets their displacements in a local array, and those of nodes that are tied to them.
  void carry(double* u) const {
    if (carried_nodes_.empty()) return;
    for (const CarriedNodes& nodes : carried_nodes_) nodes.place(u);
    space().interpolate_tied(u);
  }
  const ModelScales& scales() const { return scales_; }

  /// Returns the elastic terms, named after their blocks, the springs of grips, and the interactions.
  const std::vector<NamedForceTerm>& force_terms() const { return force_terms_; }
  const std::vector<const RateTerm*>& rate_terms() const { return rates_; }
  const std::vector<NamedInteraction>& interactions() const { return interactions_; }
  bool has_interactions() const { return !interactions_.empty(); }
  /// Returns the names of the interactions, each once, equal on all ranks.
  std::vector<std::string> interaction_names() const;
  /// Returns the names of what dissipates, equal on all ranks.
  const std::vector<std::string>& dissipation_names() const { return dissipation_names_; }
  /// Returns the matrix entries of constrained degrees of freedom. Made at the first use.
  const ConstrainedEntries& constrained_entries() const;

  // The life of its terms over steps, see Term.

  /// Returns what the terms keep, without a past.
  TermHistories create_histories() const;
  /// Returns memories for one that takes steps.
  StepMemories create_memories() const;
  /// Returns the number of histories and of memories.
  std::size_t slots() const { return slots_; }
  /// Returns the name of each one's term; several may share one.
  std::vector<std::string> slot_names() const;
  void initialize(const KnownState& start, TermHistories& histories) const;
  void begin_step(const StepStart& start, StepMemories& step) const;
  void begin_stage(const StageStart& start, StepMemories& step) const;
  /// Collective if something dissipates or has driven ends.
  ModelWork accept(const AcceptedStep& step, TermHistories& histories) const;
  /// Transfer what the terms keep, or only the part of it that another scene takes over, as far as the record has it.
  /// Throw InputError, on all ranks, if it does not fit the terms. Collective.
  void transfer(Record& record, TermHistories& histories);
  void transfer_to_another_scene(Record& record, TermHistories& histories);

 private:
  void add_block(std::size_t number, const Material& material);
  void add_damping(const LocalBlock& block, const Material& material, const Elasticity& term);
  void add_branches();
  void place_terms();
  void add_rate_term(std::unique_ptr<RateTerm> term, const std::string& name);
  void add_term(std::unique_ptr<Term> term, const std::string& name);
  void transfer(std::size_t term, Record& record, TermHistories& histories);
  std::string section_of(std::size_t term) const;
  void find_scales();

  const std::vector<Material> materials_;
  const RigidBodies rigid_bodies_;
  Discretization discretization_;
  std::unique_ptr<Mass> mass_;
  std::vector<NamedTerm> terms_;
  std::size_t slots_ = 0;
  std::vector<Body> bodies_;                    ///< blocks and their terms
  std::vector<NamedForceTerm> force_terms_;     ///< the force terms among the terms
  std::vector<NamedInteraction> interactions_;  ///< the interactions among them
  std::vector<Coupling*> couplings_;            ///< of those that couple other nodes as bodies move
  std::vector<const RateTerm*> rates_;          ///< the rate terms among them
  Damping* damping_ = nullptr;                  ///< one of the rate terms
  std::vector<std::string> dissipation_names_;
  Constraints constraints_;
  TiedConditions tied_conditions_;
  mutable std::unique_ptr<ConstrainedEntries> constrained_entries_;
  Loads loads_;
  mutable bool closed_ = false;
  ModelScales scales_;
  std::vector<Grip> grips_;
  std::vector<const Springs*> springs_;
  std::vector<DrivenGlobal> driven_globals_;
  std::vector<CarriedNodes> carried_nodes_;
  bool has_supports_ = false;
};

}  // namespace ixos
