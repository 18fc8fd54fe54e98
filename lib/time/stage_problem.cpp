#include "time/stage_problem.hpp"

#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/dot.hpp"
#include "base/error.hpp"
#include "base/phase_timer.hpp"
#include "rule/row_on_states.hpp"
#include "time/body_steps.hpp"

namespace ixos {

bool is_symmetric(const Model& model, const Stage& stage) {
  return is_gradient(model, Part::Elastic, stage.elastic) && is_gradient(model, Part::Interaction, stage.interaction);
}

namespace {

/// Returns the norm of the nodes' distances from the middle of the mesh [L0]. Collective.
double nodal_extent(const Model& model) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double sums[7] = {};  // the nodes' number, the sums of their coordinates and of the squares
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node) {
    if (mesh.is_derivative(node)) continue;
    sums[0] += 1;
    for (std::size_t i = 0; i < d; ++i) {
      const double x = mesh.coordinates[node * d + i];
      sums[1 + i] += x;
      sums[4 + i] += x * x;
    }
  }
  model.space().sum(sums, 7);
  double square = 0;
  for (std::size_t i = 0; i < d; ++i) square += std::max(sums[4 + i] - sums[1 + i] * sums[1 + i] / sums[0], 0.0);
  return std::sqrt(square);
}

}  // namespace

StageProblem::StageProblem(Model& model, const Table& table, bool matrix_free, bool mixed_steps)
    : model_(model),
      table_(table),
      exact_rates_(has_exact_rates(table)),
      has_mass_(model.mass() != nullptr),
      balance_(model),
      mixed_(mixed_steps && ixos::has_mixed_steps(model)),
      rounding_error_((mixed_ ? 8 : 2) * std::numeric_limits<double>::epsilon()) {
  const auto local = static_cast<std::size_t>(model.space().local());
  for (std::vector<double>* array : {&u_, &bracket_, &direction_, &kept_}) array->resize(local);
  if (has_mass_) known_inertia_.resize(local);
  if (!model.loads().empty()) load_.resize(local);
  if (!matrix_free) kept_points_ = balance_.sums().create_kept();
  if (!has_mass_) size_ = nodal_extent(model);
  reach_ = std::numeric_limits<double>::infinity();
  if (matrix_free)
    matrix_free_ = Teuchos::rcp(new TangentOperator(model, [this](double* values) {
      assemble(values);
      if (!model_.constraints().empty()) model_.constrained_entries().constrain(diagonal_, values);
    }));
  if (!model.rigid_bodies().empty()) {
    const GlobalUnknowns& globals = model.space().globals();
    bodies_ = std::make_unique<BodyStage>(model);
    if (!model.carried_nodes().empty()) grips_ = std::make_unique<CarriedGrips>(model);
    if (grips_ && matrix_free)
      throw InputError("nodes that a rigid body carries need an assembled tangent; use the Operator \"Assembled\"");
    globals_.resize(static_cast<std::size_t>(globals.numbers));
    border_ = Border(local, globals.free, globals.numbers);
  }
  if (model.constraints().empty()) return;
  product_.resize(local);
  reaction_.resize(static_cast<std::size_t>(model.space().owned()));
  prescribed_.resize(local);
  if (!exact_rates_) return;
  prescribed_velocity_.resize(local);
  prescribed_acceleration_.resize(local);
}

Segment StageProblem::segment(const Rule& rule) const {
  return {rule.uses_start() ? start_->u.data() : nullptr,
          rule.uses_velocity() ? path_velocity_.data() : nullptr,
          u_.data(),
          step_time_,
          stage_->end * dt_,
          &start_->histories,
          step_};
}

/// Returns where the balance of the stage is taken, at u_ and bracket_.
BalancePoint StageProblem::point() const {
  const double inverse = 1 / dt_;
  return {segment(stage_->elastic),
          segment(stage_->interaction),
          &stage_->elastic,
          &stage_->interaction,
          has_mass_ ? bracket_.data() : nullptr,
          inverse * inverse,
          Rates::Stage,
          nullptr};
}

TangentWeights StageProblem::weights() const {
  return {has_mass_ ? stage_->inertia.unknown / (dt_ * dt_) : 0.0, stage_->damping.unknown / dt_, 1, shift()};
}

void StageProblem::arm(std::size_t stage, const std::vector<State>& known, double dt, StepMemories& step) {
  const double time = known[0].time;
  stage_ = &table_.stages[stage];
  dt_ = dt;
  step_time_ = time;
  stage_time_ = time + stage_->end * dt;
  start_ = &known[0];
  step_ = &step;
  ++arm_;
  has_potential_ = is_symmetric(model_, *stage_) && rates_are_gradients(model_, stage_->rate_form) &&
                   !(has_mass_ && has_turning_bodies(model_));
  const std::vector<KnownState> states = known_states(known, stage + 1);
  if (has_mass_) evaluate_known(stage_->inertia, states, dt, known_inertia_);
  const bool path_velocity = stage_->elastic.uses_velocity() || stage_->interaction.uses_velocity();
  path_velocity_.resize(path_velocity ? u_.size() : 0);
  for (std::size_t i = 0; i < path_velocity_.size(); ++i) path_velocity_[i] = stage_->end * dt * known[0].v[i];
  if (!model_.constraints().empty())
    model_.constraints().set(stage_time_, prescribed_.data(), exact_rates_ ? prescribed_velocity_.data() : nullptr,
                             exact_rates_ ? prescribed_acceleration_.data() : nullptr);
  begin_stage(states, step);
  if (bodies_) bodies_->arm(table_, stage, states, dt);
  if (grips_) grips_->arm(start_->u.data(), has_mass_ && table_.closing == Closing::Collocate);

  bool admissible = true;
  std::fill(kept_.begin(), kept_.end(), 0.0);
  // If the last residual was at this start, its forces are there already. Obstacles that have moved and histories that
  // have grown change them.
  const bool have_end =
      at_u_.forces_of == stage_ && u_ == known[0].u && !has_moved_obstacles(model_) && !has_histories(model_);
  const auto keep = [&](Part part, const Rule& rule) {
    if (rule.kept_weight == 0) return;
    // A rule with equal weights at both ends takes its own point at the start: no other function repeats the rounding
    // of the step before, from which a restart must not differ.
    const bool has_kept = rule.mean == Mean::Points && rule.points.size() == 1 &&
                          rule.points[0].weight == rule.kept_weight && rule.points[0].to == 1 && !rule.uses_start() &&
                          !rule.uses_velocity();
    if (!have_end || !has_kept) {
      Segment start = segment_at(start_->place());
      start.step = step_;
      admissible = balance_.evaluate(part, start, has_kept ? rule : end_rule(), kept_points()) && admissible;
      at_u_ = {};
    }
    const std::vector<double>& force = balance_.force(part);
    const double weight = has_kept ? 1 : rule.kept_weight;
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] += weight * force[i];
  };
  keep(Part::Elastic, stage_->elastic);
  if (model_.has_interactions()) keep(Part::Interaction, stage_->interaction);
  if (model_.space().minimum(admissible ? 1 : 0) == 0) throw std::logic_error("the start of the step is inadmissible");
  if (!model_.loads().empty()) {
    std::fill(load_.begin(), load_.end(), 0.0);
    model_.loads().add_mean(stage_->load, time, dt, load_.data());
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] -= load_[i];
    double square = dot(load_, load_, static_cast<std::size_t>(model_.space().owned()));
    model_.space().sum(&square, 1);
    load_norm_ = std::sqrt(square);
  }

  const double coefficient = stage_->inertia.unknown / (dt * dt);
  const double rate = stage_->rate_form == RateForm::End ? stage_->velocity.unknown : 1.0;
  stiffness_ = model_.scales().elastic * (1 + largest_viscosity(model_) * rate / dt);
  rounding_ = rounding_force(known[0], coefficient);
  diagonal_ = coefficient * model_.scales().mass + model_.scales().elastic;
  if (bodies_) {
    // Held directions and attitudes stay as they are throughout the step.
    const auto first = static_cast<std::ptrdiff_t>(model_.space().first_global());
    std::copy(start_->u.begin() + first, start_->u.end(), u_.begin() + first);
    drive_bodies(model_, stage_time_, u_.data(), nullptr, nullptr);
    at_u_ = {};
  }
  if (!has_mass_) reach_ = reach(known[0]);
}

/// Ten times as far as the body is large, as it has moved, and as its supports move it.
double StageProblem::reach(const State& start) const {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  double farthest = 0;
  for (const int dof : model_.constraints().prescribed())
    farthest = std::max(farthest, std::abs(prescribed_[static_cast<std::size_t>(dof)]));
  double sums[2] = {dot(start.u, start.u, owned), static_cast<double>(owned)};
  model_.space().sum(sums, 2);
  return 10 * (size_ + std::sqrt(sums[0]) + model_.space().maximum(farthest) * std::sqrt(sums[1]));
}

void StageProblem::begin_stage(const std::vector<KnownState>& known, StepMemories& step) const {
  StageStart start;
  start.known = known;
  start.velocity = &stage_->velocity;
  start.damping = &stage_->damping;
  start.rate_form = stage_->rate_form;
  start.start_weight = stage_->rate_start;
  start.time = step_time_;
  start.length = stage_->end * dt_;
  start.mean_time = stage_->elastic.mean_time() * start.length;
  start.dt = dt_;
  if (exact_rates_ && !model_.constraints().empty()) {
    start.driven = &model_.constraints().prescribed();
    start.driven_velocity = prescribed_velocity_.data();
  }
  start.histories = &start_->histories;
  model_.begin_stage(start, step);
}

double StageProblem::rounding_force(const State& start, double coefficient) {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  const Place at{start.u.data(), start.time, &start.histories, step_};
  double squares[4] = {0, 0, dot(start.u, start.u, owned), balance_.sums().rounding(at)};
  if (has_mass_) {
    product_.resize(start.u.size());
    model_.mass()->multiply(start.u.data(), product_.data());
    squares[0] = dot(product_, product_, owned);
    model_.mass()->multiply(start.v.data(), product_.data());
    squares[1] = dot(product_, product_, owned);
  }
  if (bodies_ && has_mass_ && model_.space().comm()->getRank() == 0) {
    squares[0] += bodies_->square_of_inertia(start.u.data());
    squares[1] += bodies_->square_of_inertia(start.v.data());
  }
  model_.space().sum(squares, 4);
  // u_s is rounded, and so is the difference s (u_s - u_0) - s dt v - ... that makes the inertia.
  return rounding_error_ *
         (coefficient * (std::sqrt(squares[0]) + 2 * dt_ * std::sqrt(squares[1])) + stiffness_ * std::sqrt(squares[2]) +
          (bodies_ ? bodies_->reach() : 1) * std::sqrt(squares[3]));
}

void StageProblem::clip(const std::vector<double>& base, std::vector<double>& guess) const {
  if (!model_.has_interactions()) return;
  for (std::size_t i = 0; i < guess.size(); ++i) direction_[i] = guess[i] - base[i];
  // Obstacles are where the guess meets them.
  const Segment at_base{nullptr, nullptr, base.data(), stage_time_, 0, &start_->histories, step_};
  const double step = balance_.sums().admissible_step(at_base, end_rule(), direction_.data());
  if (step < 1)
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] = base[i] + step * direction_[i];
}

void StageProblem::inertia_bracket(const std::vector<double>& u, std::vector<double>& bracket) const {
  evaluate(stage_->inertia.unknown, u.data(), start_->u.data(), known_inertia_, bracket);
  if (!exact_rates_) return;
  for (int dof : model_.constraints().prescribed()) {
    const auto i = static_cast<std::size_t>(dof);
    bracket[i] = dt_ * dt_ * prescribed_acceleration_[i];
  }
  drive_bodies(model_, stage_time_, nullptr, nullptr, bracket.data());
  for (const DrivenGlobal& driven : model_.driven_globals()) bracket[driven.place] *= dt_ * dt_;
}

void StageProblem::move_to(const Vector& x) {
  model_.space().import(x, u_.data());
  model_.carry(u_.data());
  for (const int dof : model_.constraints().entrusted()) {
    const auto i = static_cast<std::size_t>(dof);
    prescribed_[i] = u_[i];
  }
  at_u_ = {};
  iterates_.is_last = false;
}

bool StageProblem::residual(const Vector& x, Vector& f) {
  const TimedScope timed(Phase::Residual);
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  move_to(x);
  at_u_.forces_of = stage_;
  if (has_mass_) inertia_bracket(u_, bracket_);
  const BalancePoint at = point();
  const bool admissible = balance_.evaluate(at, kept_points());
  const std::vector<double>& elastic = balance_.force(Part::Elastic);
  const std::vector<double>& interaction = balance_.force(Part::Interaction);
  // Norms of the three parts, the number of ranks on which some part is inadmissible, the number of values that are not
  // yet reached, the norm of u, and the rounding of interactions.
  double sums[7] = {has_mass_ ? dot(balance_.inertia(), balance_.inertia(), owned) : 0.0,
                    dot(elastic, elastic, owned),
                    0,
                    0,
                    0,
                    dot(u_, u_, owned),
                    0};
  if (model_.has_interactions()) {
    sums[2] = dot(interaction, interaction, owned);
    // A stiff law that begins to act within the step has no rounding at the step's start.
    if (has_laws_of_every_gap(model_))
      sums[6] = balance_.sums().rounding({u_.data(), step_time_, &start_->histories, step_});
  }
  sums[3] = admissible ? 0 : 1;
  for (int dof : model_.constraints().dofs()) {
    const auto i = static_cast<std::size_t>(dof);
    if (!is_reached(i, u_[i])) sums[4] += 1;
  }
  model_.space().sum(sums, 7);
  moving_ = sums[4] > 0;
  // A rounding beyond all numbers would pass any force as converged.
  if (sums[3] > 0 || !std::isfinite(sums[0] + sums[1] + sums[2] + sums[6])) return false;
  at_u_.imported = arm_;
  if (!kept_points_.empty()) at_u_.kept = arm_;
  // After a long step the rounding errors are larger than at its start.
  const double norm = std::sqrt(sums[5]);
  rounding_here_ = rounding_error_ * ((diagonal_ + stiffness_ - model_.scales().elastic) * norm + std::sqrt(sums[6]));
  // Without an equilibrium a body flies off until the rounding of u passes any load.
  if (norm > reach_) rounding_here_ = 0;
  lost_ = norm > 10 * reach_ && !has_springs(model_);
  scale_ = std::max(std::sqrt(std::max({sums[0], sums[1], sums[2]})), load_norm_);

  const auto view = f.getLocalViewHost(Tpetra::Access::OverwriteAll);
  double* out = view.data();
  balance_.sum(at, kept_.data(), out);
  if (bodies_) sum_globals();
  constrain_residual(out);
  if (bodies_ && moving_) move_globals(bracket_);  // on all ranks, also those that hold nothing
  if (grips_) add_grip_forces();
  for (std::size_t i = owned; i < view.extent(0); ++i)
    out[i] = globals_[static_cast<std::size_t>(model_.space().globals().free[i - owned])];
  return true;
}

void StageProblem::record_forces(State& state) const {
  const auto owned = static_cast<std::ptrdiff_t>(model_.space().owned());
  if (!load_.empty()) {
    state.load.assign(load_.begin(), load_.begin() + owned);
    state.load_on_globals.assign(load_.begin() + model_.space().first_global(), load_.end());
  }
  if (!model_.driven_globals().empty()) {
    // The forces that drive them are what the balance lacks.
    const auto first = static_cast<std::size_t>(model_.space().first_global());
    if (load_.empty()) state.load_on_globals.assign(globals_.size(), 0.0);
    for (const DrivenGlobal& driven : model_.driven_globals())
      state.load_on_globals[driven.place - first] += globals_[driven.place - first];
  }
  state.reaction = reaction_;
}

double StageProblem::admissible_step(const Vector& x, const Vector& direction) {
  if (!model_.has_interactions()) return 1.0;
  move_to(x);
  std::fill(direction_.begin() + model_.space().first_global(), direction_.end(), 0.0);
  model_.space().import(direction, direction_.data());
  if (grips_) {
    for (const CarriedNodes& nodes : model_.carried_nodes()) nodes.direct(u_.data(), direction_.data());
    model_.space().interpolate_tied(direction_.data());
  }
  return balance_.sums().admissible_step(segment(stage_->interaction), stage_->interaction, direction_.data());
}

double StageProblem::convergence_bound(double relative_tolerance) const {
  // Before a wall that the support drives the body through, the forces grow until they pass any distance left.
  if (moving_) return 0;
  return std::max({relative_tolerance * scale_, rounding_, rounding_here_});
}

}  // namespace ixos
