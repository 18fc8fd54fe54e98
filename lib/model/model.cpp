#include "model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "model/axis.hpp"

namespace ixos {
Model::Model(LocalMesh mesh, const Comm& comm, const std::vector<Material>& materials, Inertia inertia)
    : materials_(materials),
      discretization_(std::move(mesh), comm),
      mesh_(discretization_.mesh()),
      space_(discretization_.space()),
      pattern_(discretization_.pattern()),
      loads_(static_cast<std::size_t>(space_.local())) {
  if (inertia != Inertia::None) mass_ = std::make_unique<Mass>(mesh_, pattern_, inertia == Inertia::Lumped);
  for (const Material& material : materials) {
    check_material(material, inertia != Inertia::None);
    const auto same = [&](const Material& other) { return other.block == material.block; };
    if (std::count_if(materials.begin(), materials.end(), same) > 1)
      throw InputError("block \"" + material.block + "\" has two materials; each list must name a different Block");
    for (std::size_t b : mesh_.blocks_named(material.block)) add_block(b, material);
  }
  for (const LocalBlock& block : mesh_.blocks)
    if (std::none_of(materials.begin(), materials.end(), [&](const Material& m) { return m.block == block.name; }))
      throw InputError("block \"" + block.name + "\" has no material; add a list that names this Block");
  add_branches();
  hold_axis(mesh_, constraints_);
  find_scales();
}

void Model::add_block(std::size_t number, const Material& material) {
  const LocalBlock& block = mesh_.blocks[number];
  auto term = make_elastic_term(mesh_, block, pattern_, material.law, material.points, material.formulation);
  bodies_.push_back({term.get(), nullptr, nullptr, number, material});
  force_terms_.push_back({block.name, term.get()});
  add_term(std::move(term), block.name);
  if (material.viscosity != 0) {
    if (material.formulation != Formulation::Standard)
      throw InputError("block \"" + block.name + "\": viscosity is offered for Standard elements only");
    const Lame lame = material.law->lame();
    const Hooke law{{material.viscosity * lame.mu, material.viscosity * lame.lambda}};
    auto viscosity = make_viscous_term(mesh_, block, pattern_, law, material.points);
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
    const LocalBlock& block = mesh_.blocks[body.block];
    auto term = make_maxwell_term(mesh_, block, pattern_, material.branches, material.history_update, material.points);
    body.viscoelasticity = term.get();
    const std::string name = "viscoelasticity of " + block.name;
    force_terms_.push_back({name, term.get()});
    add_term(std::move(term), name);
  }
}

void Model::add_damping(const LocalBlock& block, const Material& material, const Elasticity& term) {
  if (material.mass_damping == 0 && material.stiffness_damping == 0) return;
  if (damping_ == nullptr) {
    auto damping = std::make_unique<Damping>(pattern_, mesh_.dimension, space_.local());
    damping_ = damping.get();
    add_rate_term(std::move(damping), "damping");
  }
  if (material.mass_damping != 0) {
    auto block_mass = std::make_unique<Mass>(mesh_, pattern_, mass_->is_lumped());
    block_mass->add_block(block, material.density);
    damping_->add_mass(material.mass_damping, std::move(block_mass));
  }
  if (material.stiffness_damping != 0) damping_->add_stiffness(material.stiffness_damping, term);
}

void Model::add_rate_term(std::unique_ptr<RateTerm> term, const std::string& name) {
  rates_.push_back(term.get());
  add_term(std::move(term), name);
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
  terms_.push_back({name, std::move(term), account});
}

void Model::couple(const std::vector<std::vector<int>>& stencils) {
  discretization_.couple(stencils);
  place_terms();
}

void Model::place_terms() {
  if (mass_) mass_->place();
  for (const NamedTerm& named : terms_) named.term->place(pattern_);
  constrained_entries_.reset();
}

void Model::update_couplings(const double* u) {
  if (moving_.empty()) return;
  double changed = 0;
  for (Interaction* term : moving_)
    if (term->update_stencils(u)) changed = 1;
  if (space_.maximum(changed) == 0) return;
  std::vector<std::vector<int>> stencils;
  for (const Interaction* term : moving_)
    for (std::vector<int>& stencil : term->stencils()) stencils.push_back(std::move(stencil));
  discretization_.couple_for_now(std::move(stencils));
  place_terms();
}

template <class Visit>
void Model::for_each(Part part, const Visit& visit) const {
  for (const NamedForceTerm& named : force_terms_)
    if (named.term->part() == part) visit(*named.term);
}

bool Model::is_gradient(Part part, const Rule& rule) const {
  bool result = true;
  for_each(part, [&](const ForceTerm& term) { result = result && term.is_gradient(rule); });
  return result;
}

bool Model::force(Part part, const Segment& segment, const Rule& rule, double* f) const {
  std::fill_n(f, space_.local(), 0.0);
  bool admissible = true;
  for_each(part, [&](const ForceTerm& term) { admissible = term.add_force(segment, rule, f) && admissible; });
  return admissible;
}

void Model::add_tangent(Part part, const Segment& segment, const Rule& rule, Tangent kind, double* values) const {
  for_each(part, [&](const ForceTerm& term) { term.add_tangent(segment, rule, kind, values); });
}

KeptForces Model::create_kept() const {
  KeptForces kept;
  for (const NamedForceTerm& named : force_terms_) kept.push_back(named.term->create_kept());
  return kept;
}

bool Model::force_and_keep(Part part, const Segment& segment, const Rule& rule, KeptForces& kept, double* f) const {
  std::fill_n(f, space_.local(), 0.0);
  kept.resize(force_terms_.size());  // terms that were added later keep nothing
  bool admissible = true;
  for (std::size_t i = 0; i < force_terms_.size(); ++i) {
    const ForceTerm& term = *force_terms_[i].term;
    if (term.part() != part) continue;
    const bool good = kept[i] ? term.add_force_and_keep(segment, rule, *kept[i], f) : term.add_force(segment, rule, f);
    admissible = admissible && good;
  }
  return admissible;
}

void Model::add_kept_tangent(Part part, const Segment& segment, const Rule& rule, Tangent kind, const KeptForces& kept,
                             double* values) const {
  for (std::size_t i = 0; i < force_terms_.size(); ++i) {
    const ForceTerm& term = *force_terms_[i].term;
    if (term.part() != part) continue;
    if (kept[i])
      term.add_kept_tangent(segment, rule, kind, *kept[i], values);
    else
      term.add_tangent(segment, rule, kind, values);
  }
}

bool Model::rates_are_gradients(RateForm form) const {
  return std::all_of(rates_.begin(), rates_.end(), [&](const RateTerm* term) { return term->is_gradient(form); });
}

void Model::add_rate_force(const double* u, double* f) const {
  for (const RateTerm* term : rates_) term->add_force(u, f);
}

void Model::add_rate_tangent(const double* u, double* values) const {
  for (const RateTerm* term : rates_) term->add_tangent(u, values);
}

double Model::local_rate_potential(const double* u) const {
  double sum = 0;
  for (const RateTerm* term : rates_) sum += term->potential(u);
  return sum;
}

void Model::add_rate_force_at(double factor, const double* u, const double* v, double* f) const {
  for (const RateTerm* term : rates_) term->add_force_at(factor, u, v, f);
}

void Model::add_rate_tangent_at(double by_velocity, double by_displacement, const double* u, const double* v,
                                double* values) const {
  for (const RateTerm* term : rates_) term->add_tangent_at(by_velocity, by_displacement, u, v, values);
}

void Model::add_rate_row_sums(const double* u, double* sums) const {
  for (const RateTerm* term : rates_) term->add_row_sums(u, sums);
}

bool Model::has_viscoelasticity() const {
  return std::any_of(materials_.begin(), materials_.end(), [](const Material& own) { return !own.branches.empty(); });
}

double Model::largest_viscosity() const {
  double largest = 0;
  for (const Body& body : bodies_) largest = std::max(largest, body.material.viscosity);
  return largest;
}

std::vector<std::unique_ptr<TangentAction>> Model::actions(Part part) const {
  std::vector<std::unique_ptr<TangentAction>> result;
  for_each(part, [&](const ForceTerm& term) { result.push_back(term.create_action()); });
  return result;
}

bool Model::add_row_sums(Part part, const Segment& segment, double* sums) const {
  bool admissible = true;
  for_each(part, [&](const ForceTerm& term) { admissible = term.add_row_sums(segment, sums) && admissible; });
  return admissible;
}

double Model::local_energy(Part part, const double* u) const {
  double sum = 0;
  for_each(part, [&](const ForceTerm& term) { sum += term.energy(u); });
  return sum;
}

double Model::local_potential(Part part, const Rule& rule, const double* u) const {
  double sum = 0;
  if (part == Part::Elastic) for_each(part, [&](const ForceTerm& term) { sum += term.potential(u); });
  if (part == Part::Interaction)
    for (const Interaction* term : interactions_)
      if (term->followed(rule).mean == Mean::Points) sum += term->potential(u);
  return sum;
}

double Model::energy(Part part, const double* u) const {
  double sum = local_energy(part, u);
  space_.sum(&sum, 1);
  return sum;
}

std::vector<LinearPart> Model::linear_parts(double mass, double damping) const {
  std::vector<LinearPart> parts(bodies_.size());
  for (std::size_t i = 0; i < parts.size() && mass_; ++i) {
    const Material& material = bodies_[i].material;
    parts[i] = {damping * material.stiffness_damping, (mass + damping * material.mass_damping) * material.density};
  }
  return parts;
}

void Model::do_without_matrices() {
  if (damping_) damping_->do_without_matrix();
}

void Model::find_scales() {
  const std::vector<double> rest(static_cast<std::size_t>(space_.local()), 0.0);
  std::vector<double> stiffness(rest.size(), 0.0), inertia(rest.size(), 0.0);
  for (const Body& body : bodies_) {
    body.term->add_diagonal({nullptr, nullptr, rest.data()}, stiffness.data());
    if (body.viscoelasticity != nullptr) body.viscoelasticity->add_diagonal(rest.data(), stiffness.data());
  }
  if (mass_) mass_->add_diagonal(1, inertia.data());
  double sums[3] = {0, 0, static_cast<double>(space_.owned())};
  double stiffest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(space_.owned()); ++i) {
    sums[0] += stiffness[i];
    sums[1] += inertia[i];
    if (inertia[i] > 0) stiffest = std::max(stiffest, stiffness[i] / inertia[i]);
  }
  space_.sum(sums, 3);
  elastic_scale_ = sums[0] / sums[2];
  mass_scale_ = sums[1] / sums[2];
  stiffest_ = space_.maximum(stiffest);
}

const ConstrainedEntries& Model::constrained_entries() const {
  if (!constrained_entries_ || constrained_entries_->constraints() != constraints_.dofs().size())
    constrained_entries_ = std::make_unique<ConstrainedEntries>(pattern_, constraints_);
  return *constrained_entries_;
}

void Model::multiply_constrained_columns(const double* values, const double* x, double* result) const {
  constrained_entries().multiply(values, x, result);
}

void Model::add_to_diagonal(double value, double* values) const {
  for (int row = 0; row < pattern_.rows(); ++row)
    for (int i = 0; i < mesh_.dimension; ++i) values[pattern_.offset(row, row) + pattern_.stride(row) * i + i] += value;
}

void Model::constrain_matrix(double diagonal, double* values) const {
  if (!constraints_.empty()) constrained_entries().constrain(diagonal, values);
}

}  // namespace ixos
