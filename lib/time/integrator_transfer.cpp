// The integrator's state in checkpoints, and how an integrator resumes from it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/error.hpp"
#include "time/body_steps.hpp"
#include "time/integrator.hpp"

namespace ixos {

/// Throws if the checkpoint lacks a part of the state.
void Integrator::check_whole(const char* name, const std::vector<double>& field, Extent extent) const {
  const int size = extent == Extent::Local ? model_.space().local() : model_.space().owned();
  if (field.size() != static_cast<std::size_t>(size))
    throw InputError(fmt::format("\"{}\" is empty, but the state needs it", name));
}

namespace {

/// Names the rigid bodies; throws InputError if the record has others.
void transfer_bodies(Record& record, const Model& model) {
  const RigidBodies& bodies = model.rigid_bodies();
  const char* const section_name = "rigid bodies";
  const auto refuse = [] {
    throw InputError(
        "the state has other rigid bodies, or in another order: a run continues with the same ones, as free and as "
        "prescribed as they were");
  };
  if (record.loading() && record.has_section(section_name) == bodies.empty()) refuse();
  if (bodies.empty()) return;
  const Record::Section section(record, section_name);
  std::size_t count = bodies.size();
  record.number("count", count);
  if (count != bodies.size()) refuse();
  for (std::size_t i = 0; i < count; ++i) {
    std::string name = bodies[i].name();
    record.text(("body " + std::to_string(i + 1)).c_str(), name);
    if (name != bodies[i].name()) refuse();
  }
}

}  // namespace

/// Marks the checkpoint of a quasi-static state, whose velocity is the rate of its last step. Returns whether the state
/// is one.
bool Integrator::transfer_kind(Record& record) {
  const bool mine = is_static(table_);
  if (record.in_memory()) return mine;
  if (record.loading() ? !record.has_section("static") : !mine) return false;
  const Record::Section section(record, "static");
  bool is = true;  // a section needs an entry
  record.number("quasi-static", is);
  return true;
}

void Integrator::transfer(Record& record) {
  const Record::Section section(record, "integrator");
  if (record.in_memory()) {
    long version = model_.discretization().version();
    record.number("discretization", version);
    if (version != model_.discretization().version() && !model_.couples_anew())
      throw std::logic_error("the discretization has changed since the state was saved");
  }
  follow_slots();
  transfer_bodies(record, model_);
  State& state = states_.front();
  record.field("displacement", state.u, Extent::Local);
  record.field("velocity", state.v, Extent::Local);
  record.number("time", state.time);
  record.number("time carry", time_carry_);
  record.number("dissipated energy", dissipated_);
  record.number("external work", external_work_);
  if (!std::isfinite(state.time)) throw InputError(fmt::format("the time {} is not finite", state.time));
  check_whole("displacement", state.u, Extent::Local);
  check_whole("velocity", state.v, Extent::Local);
  const bool from_static = transfer_kind(record);
  if (record.loading()) in_step_ = false;
  if (!record.loading() || record.same_scene()) return transfer_derived(record);
  refuse_jump();
  if (from_static && !keeps_static_rates_) std::fill(state.v.begin(), state.v.end(), 0.0);
  resumed_jump_ = velocity_jump();
  const double carry = time_carry_, dissipated = dissipated_, external_work = external_work_;
  begin_at(std::vector<double>(state.u), std::vector<double>(state.v), state.time);
  model_.transfer_to_another_scene(record, state.histories);
  find_forces();
  time_carry_ = carry;
  dissipated_ = dissipated_before_ = dissipated;
  external_work_ = external_work;
}

/// Throws unless a changed motion passes through the present values of its degrees of freedom.
void Integrator::refuse_jump() const {
  const State& state = states_.front();
  std::vector<double> there(state.u);
  model_.constraints().set(state.time, there.data(), nullptr, nullptr);
  model_.constraints().planes().project(there.data(), model_.mesh().nodes());
  drive_bodies(model_, state.time, there.data(), nullptr, nullptr);
  double jump = 0, size = 0;
  for (std::size_t i = 0; i < there.size(); ++i) {
    jump = std::max(jump, std::abs(there[i] - state.u[i]));
    size = std::max(size, std::abs(state.u[i]));
  }
  jump = model_.space().maximum(jump);
  if (jump > 1e-9 * model_.space().maximum(size))
    throw InputError(
        fmt::format("a prescribed displacement would jump by {:.3g} L0 at t = {:.6g} T0", jump, state.time));
}

/// Returns the largest difference of a prescribed velocity from the present one.
double Integrator::velocity_jump() const {
  const State& state = states_.front();
  std::vector<double> there(state.v);
  model_.constraints().set(state.time, nullptr, there.data(), nullptr);
  model_.constraints().planes().project(there.data(), model_.mesh().nodes());
  double jump = 0;
  for (std::size_t i = 0; i < there.size(); ++i) jump = std::max(jump, std::abs(there[i] - state.v[i]));
  return model_.space().maximum(jump);
}

void Integrator::transfer_derived(Record& record) {
  State& state = states_.front();
  record.field("acceleration", state.a, Extent::Local);
  record.field("load", state.load, Extent::Owned);
  if (!model_.loads().empty() || !model_.driven_globals().empty()) {
    state.load_on_globals.resize(static_cast<std::size_t>(model_.space().globals().numbers));
    for (std::size_t i = 0; i < state.load_on_globals.size(); ++i)
      record.number(("load on global " + std::to_string(i + 1)).c_str(), state.load_on_globals[i]);
  }
  record.field("reaction", state.reaction, Extent::Owned);
  record.number("dissipated before", dissipated_before_);
  for (std::size_t i = 0; i < dissipations_.size(); ++i)
    record.number(("dissipated: " + model_.dissipation_names()[i]).c_str(), dissipations_[i]);
  model_.transfer(record, state.histories);
  if (record.loading()) follow_couplings();  // before the solvers take what they keep of those matrices
  record.field("previous displacement", previous_u_, Extent::Local);
  record.field("earlier displacement", earlier_u_, Extent::Local);
  record.number("earlier step", earlier_dt_);
  auto nearest = static_cast<int>(nearest_);
  record.number("nearest predictor", nearest);
  if (nearest < 0 || nearest >= static_cast<int>(Predictor::Nearest))
    throw InputError(fmt::format("there is no predictor {}", nearest));
  nearest_ = static_cast<Predictor>(nearest);
  record.field("previous velocity", previous_.v, Extent::Local);
  record.number("previous step", previous_.dt);
  record.number("previous known", previous_.known);
  record.number("judged", judged_);
  record.number("acceleration known", acceleration_known_);
  if (acceleration_known_) check_whole("acceleration", state.a, Extent::Local);
  if (!model_.loads().empty()) check_whole("load", state.load, Extent::Owned);
  if (!model_.constraints().empty()) check_whole("reaction", state.reaction, Extent::Owned);
  if (previous_.known) check_whole("previous velocity", previous_.v, Extent::Local);
  const bool looks_back = table_.predictor == Predictor::Extrapolation || table_.predictor == Predictor::Quadratic ||
                          table_.predictor == Predictor::Nearest;
  if (previous_.dt != 0 && looks_back) check_whole("previous displacement", previous_u_, Extent::Local);
  if (earlier_dt_ != 0) {
    check_whole("previous displacement", previous_u_, Extent::Local);
    check_whole("earlier displacement", earlier_u_, Extent::Local);
  }
  if (usable(nearest_) != nearest_) throw InputError("the nearest predictor needs earlier displacements");
  int points = table_.interaction_points;
  record.number("interaction points", points);
  set_interaction_points(points);
  attempted_dt_ = 0;
  if (stable_step_) stable_step_->transfer(record);
  if (record.loading() && !record.exact()) return;
  for (std::size_t i = 0; i < solvers_.size(); ++i) {
    const Record::Section solver(record, "solver " + std::to_string(i + 1));
    solvers_[i]->newton.transfer(record);
  }
}

}  // namespace ixos
