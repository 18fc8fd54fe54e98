#include "model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "material/elastic_law.hpp"
#include "model/axis.hpp"
#include "term/support/springs.hpp"

namespace ixos {
namespace {

void check_body(const RigidBody& body, bool moves) {
  if (moves && !body.free().empty() && !(body.mass() > 0))
    throw InputError(fmt::format("the rigid body \"{}\" has no mass, which it needs to move in time", body.name()));
}

}  // namespace

Model::Model(LocalMesh mesh, const Comm& comm, const std::vector<Material>& materials, Inertia inertia,
             RigidBodies rigid_bodies)
    : materials_(materials),
      rigid_bodies_(std::move(rigid_bodies)),
      discretization_(std::move(mesh), comm, {rigid_bodies_.numbers(), rigid_bodies_.free()}),
      loads_(static_cast<std::size_t>(space().local())) {
  for (const RigidBody& body : rigid_bodies_) check_body(body, inertia != Inertia::None);
  if (inertia != Inertia::None) mass_ = std::make_unique<Mass>(this->mesh(), pattern(), inertia == Inertia::Lumped);
  for (const Material& material : materials) {
    check_material(material, inertia != Inertia::None);
    const auto same = [&](const Material& other) { return other.block == material.block; };
    if (std::count_if(materials.begin(), materials.end(), same) > 1)
      throw InputError("block \"" + material.block + "\" has two materials; each list must name a different Block");
    for (std::size_t b : this->mesh().blocks_named(material.block)) add_block(b, material);
  }
  for (const LocalBlock& block : this->mesh().blocks)
    if (std::none_of(materials.begin(), materials.end(), [&](const Material& m) { return m.block == block.name; }))
      throw InputError("block \"" + block.name + "\" has no material; add a list that names this Block");
  add_branches();
  if (mass_) together<InputError>(comm, [&] { mass_->check_lumped(); });
  hold_axis(this->mesh(), constraints_);
  find_scales();
}

void Model::add_block(std::size_t number, const Material& material) {
  const LocalBlock& block = mesh().blocks[number];
  auto term = make_elastic_term(mesh(), block, pattern(), material.law, material.points, material.formulation);
  bodies_.push_back({term.get(), nullptr, nullptr, number, material});
  force_terms_.push_back({block.name, term.get()});
  add_term(std::move(term), block.name);
  if (material.viscosity != 0) {
    const Lame lame = material.law->lame();
    const Hooke law{{material.viscosity * lame.mu, material.viscosity * lame.lambda}};
    auto viscosity = make_viscous_term(mesh(), block, pattern(), law, material.points);
    bodies_.back().viscosity = viscosity.get();
    add_rate_term(std::move(viscosity), "viscosity of " + block.name);
  }
  if (!mass_) return;
  mass_->add_block(block, material.density);
  add_damping(block, material, *bodies_.back().term);
}

/// After all elastic terms: linear_parts() counts on their order.
void Model::add_branches() {
  for (Body& body : bodies_) {
    const Material& material = body.material;
    if (material.branches.empty()) continue;
    const LocalBlock& block = mesh().blocks[body.block];
    auto term =
        make_maxwell_term(mesh(), block, pattern(), material.branches, material.history_update, material.points);
    body.viscoelasticity = term.get();
    const std::string name = "viscoelasticity of " + block.name;
    force_terms_.push_back({name, term.get()});
    add_term(std::move(term), name);
  }
}

void Model::add_damping(const LocalBlock& block, const Material& material, const Elasticity& term) {
  if (material.mass_damping == 0 && material.stiffness_damping == 0) return;
  if (damping_ == nullptr) {
    auto damping = std::make_unique<Damping>(pattern(), mesh().dimension, space().local());
    damping_ = damping.get();
    add_rate_term(std::move(damping), "damping");
  }
  if (material.mass_damping != 0) {
    auto block_mass = std::make_unique<Mass>(mesh(), pattern(), mass_->is_lumped());
    block_mass->add_block(block, material.density);
    damping_->add_mass(material.mass_damping, std::move(block_mass));
  }
  if (material.stiffness_damping != 0) damping_->add_stiffness(material.stiffness_damping, term);
}

void Model::add_rate_term(std::unique_ptr<RateTerm> term, const std::string& name) {
  rates_.push_back(term.get());
  add_term(std::move(term), name);
}

void Model::set_prescribed(double time, double* u, double* v, double* a) const {
  if (constraints_.empty()) return;
  constraints_.set(time, u, v, a);
  for (double* const array : {u, v, a}) {
    if (array == nullptr) continue;
    constraints_.planes().project(array, mesh().nodes());
    space().interpolate_tied(array);
  }
}

void Model::close() const {
  check_tied_conditions();
  const auto refuse = [this](int node) {
    if (mesh().is_tied(node)) throw std::logic_error("a tied node is constrained; constrain the nodes that it follows");
  };
  for (const int dof : constraints_.dofs()) refuse(dof / mesh().dimension);
  constraints_.planes().for_each(refuse);
  closed_ = true;
  constraints_.close();
  loads_.close();
}

void Model::check_open() const {
  if (closed_)
    throw std::logic_error(
        "an interaction or a condition is added after an integrator or an evaluator was made of the model");
}

void Model::add_term(std::unique_ptr<Term> term, const std::string& name) {
  int account = -1;
  if (term->dissipates()) {
    const auto found = std::find(dissipation_names_.begin(), dissipation_names_.end(), name);
    account = static_cast<int>(found - dissipation_names_.begin());
    if (found == dissipation_names_.end()) dissipation_names_.push_back(name);
  }
  term->take_slot(slots_);
  terms_.push_back({name, std::move(term), account});
}

void Model::couple(const std::vector<std::vector<int>>& stencils) {
  discretization_.couple(stencils);
  place_terms();
}

void Model::place_terms() {
  if (mass_) mass_->place();
  for (const NamedTerm& named : terms_) named.term->place(pattern());
  constrained_entries_.reset();
}

void Model::update_couplings(const double* u) {
  if (couplings_.empty()) return;
  double changed = 0;
  for (Coupling* coupling : couplings_)
    if (coupling->update_stencils(u)) changed = 1;
  if (space().maximum(changed) == 0) return;
  std::vector<std::vector<int>> stencils;
  for (const Coupling* coupling : couplings_)
    for (std::vector<int>& stencil : coupling->stencils()) stencils.push_back(std::move(stencil));
  discretization_.couple_for_now(std::move(stencils));
  place_terms();
}

void Model::do_without_matrices() {
  if (damping_) damping_->do_without_matrix();
}

void Model::find_scales() {
  const std::vector<double> rest(static_cast<std::size_t>(space().local()), 0.0);
  std::vector<double> stiffness(rest.size(), 0.0), inertia(rest.size(), 0.0);
  const TermHistories histories = create_histories();
  for (const Body& body : bodies_) {
    body.term->add_diagonal({nullptr, nullptr, rest.data()}, stiffness.data());
    if (body.viscoelasticity != nullptr)
      body.viscoelasticity->add_diagonal({rest.data(), 0, &histories}, stiffness.data());
  }
  space().ties().condense_diagonal(stiffness.data(), static_cast<std::size_t>(mesh().dimension));
  if (mass_) mass_->add_diagonal(1, inertia.data());
  double sums[3] = {0, 0, static_cast<double>(space().owned())};
  double stiffest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(space().owned()); ++i) {
    sums[0] += stiffness[i];
    sums[1] += inertia[i];
    if (inertia[i] > 0) stiffest = std::max(stiffest, stiffness[i] / inertia[i]);
  }
  space().sum(sums, 3);
  scales_ = {sums[0] / sums[2], sums[1] / sums[2], space().maximum(stiffest)};
}

const ConstrainedEntries& Model::constrained_entries() const {
  if (!constrained_entries_ || !constrained_entries_->are_of(constraints_))
    constrained_entries_ = std::make_unique<ConstrainedEntries>(pattern(), constraints_);
  return *constrained_entries_;
}

void Model::add_interaction(std::unique_ptr<Interaction> term, const std::string& name) {
  interactions_.push_back({name, term.get()});
  if (Coupling* const coupling = term->coupling()) couplings_.push_back(coupling);
  force_terms_.push_back({name, term.get()});
  std::string account = name;
  if (term->reports().has(SurfaceNumber::Damage)) account = "damage of " + name;
  if (term->has_friction()) account = "friction of " + name;
  add_term(std::move(term), account);
}

std::vector<std::string> Model::interaction_names() const {
  std::vector<std::string> names;
  for (const NamedInteraction& named : interactions_)
    if (std::find(names.begin(), names.end(), named.name) == names.end()) names.push_back(named.name);
  return names;
}

void Model::drive_body(std::size_t body, std::size_t direction, std::shared_ptr<const TimeFunction> motion) {
  check_open();
  const std::vector<std::size_t>& free = rigid_bodies_[body].free();
  if (direction >= 3) throw std::out_of_range("a body is driven along a direction of space");
  if (std::find(free.begin(), free.end(), direction) != free.end())
    throw InputError("the rigid body \"" + rigid_bodies_[body].name() +
                     "\" moves freely along a direction that is driven");
  driven_globals_.push_back({first_number(body) + direction, std::move(motion)});
}

void Model::carry_nodes(std::size_t body, const std::vector<int>& nodes) {
  check_open();
  for (const int node : nodes) {
    if (mesh().is_tied(node)) throw InputError("a tied node cannot be carried by a rigid body");
    for (int i = 0; i < mesh().dimension; ++i) constraints_.entrust(node * mesh().dimension + i);
  }
  carried_nodes_.emplace_back(mesh(), rigid_bodies_[body], first_number(body), nodes);
}

void Model::add_supports(const std::string& name, std::unique_ptr<Springs> springs,
                         std::unique_ptr<Dashpots> dashpots) {
  check_open();
  has_supports_ = true;
  if (springs) {
    springs_.push_back(springs.get());
    force_terms_.push_back({name, springs.get()});
    add_term(std::move(springs), "springs of " + name);
  }
  if (dashpots) add_rate_term(std::move(dashpots), "dashpots of " + name);
}

void Model::add_grip(Grip grip, std::unique_ptr<Springs> springs, std::unique_ptr<Dashpots> dashpots) {
  check_open();
  grip.springs = springs.get();
  grip.dashpots = dashpots.get();
  if (!grip.rigid) add_supports(grip.name, std::move(springs), std::move(dashpots));
  grips_.push_back(std::move(grip));
}

}  // namespace ixos
