#include <utility>

#include "rule/row_on_states.hpp"
#include "term/support/diagonal_places.hpp"
#include "term/support/springs.hpp"

namespace ixos {

Dashpots::Dashpots(DrivenEnds ends, const Pattern& pattern, std::size_t local)
    : ends_(std::move(ends)),
      owned_(owned_dofs(pattern)),
      local_(local),
      places_(diagonal_places(ends_.dofs, pattern, ends_.first_global)) {}

void Dashpots::place(const Pattern& pattern) { places_ = diagonal_places(ends_.dofs, pattern, ends_.first_global); }

/// A stage: the damping row.
struct Dashpots::Memory final : StepMemory {
  double unknown = 0;
  double dt = 0;
  const double* from = nullptr;
  std::vector<double> known;  ///< the row without its unknown part, local

  /// Returns dt times the velocity that c multiplies.
  double row(std::size_t dof, const double* u) const { return unknown * (u[dof] - from[dof]) + known[dof]; }
};

std::unique_ptr<StepMemory> Dashpots::create_memory() const { return std::make_unique<Memory>(); }

const Dashpots::Memory& Dashpots::memory(const StepMemories* step) const { return step->of<Memory>(slot()); }

void Dashpots::begin_stage(const StageStart& start, StepMemories& step) const {
  auto& memory = step.of<Memory>(slot());
  memory.unknown = start.damping->unknown;
  memory.dt = start.dt;
  memory.from = start.known.front().u;
  memory.known.resize(local_);
  evaluate_known(*start.damping, start.known, start.dt, memory.known);
}

void Dashpots::add_force(const Place& at, double* f) const {
  const Memory& stage = memory(at.step);
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k) {
    const auto i = static_cast<std::size_t>(ends_.dofs[k]);
    f[i] += ends_.coefficients[k] * stage.row(i, at.u) / stage.dt;
  }
}

void Dashpots::add_tangent(const Place& at, double* values) const {
  const Memory& stage = memory(at.step);
  tangent_factor_ = stage.unknown / stage.dt;
  add_to_places(tangent_factor_, ends_.coefficients, places_, values);
}

double Dashpots::potential(const Place& at) const {
  const Memory& stage = memory(at.step);
  double sum = 0;
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k)
    if (const auto i = static_cast<std::size_t>(ends_.dofs[k]); counts(ends_, i, owned_))
      sum += ends_.coefficients[k] * stage.row(i, at.u) * stage.row(i, at.u);
  return sum / (2 * stage.unknown * stage.dt);
}

void Dashpots::add_force_at(double factor, const double*, const double* v, double* f) const {
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k)
    f[ends_.dofs[k]] += factor * ends_.coefficients[k] * v[ends_.dofs[k]];
}

void Dashpots::add_tangent_at(double by_velocity, double, const double*, const double*, double* values) const {
  add_to_places(by_velocity, ends_.coefficients, places_, values);
}

void Dashpots::add_row_sums(const double*, double* sums) const { add_diagonal(1.0, sums); }

void Dashpots::add_diagonal(double factor, double* d) const {
  tangent_factor_ = factor;
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k) d[ends_.dofs[k]] += factor * ends_.coefficients[k];
}

/// Returns the work of c v on u, or with `relative` that of c (v - w') on u - w, as the scheme sums it.
double Dashpots::dissipated(const AcceptedStep& step, bool relative) const {
  const bool stages = step.work->form == WorkSum::Form::Stages;
  double sum = 0;
  const auto for_each = [&](const auto& work) {
    for (std::size_t k = 0; k < ends_.dofs.size(); ++k)
      if (const auto i = static_cast<std::size_t>(ends_.dofs[k]); counts(ends_, i, owned_))
        sum += ends_.coefficients[k] * work(i);
  };
  const auto rates = [&](double time) {
    return relative ? rates_of(ends_, time, local_) : std::vector<double>(local_, 0.0);
  };
  if (stages) {
    for (std::size_t s = 0; s < step.states.size(); ++s) {
      const double* v = step.states[s].v;
      const double weight = step.dt * step.work->weights[s];
      const std::vector<double> w = rates(step.states[s].time);
      for_each([&](std::size_t i) { return weight * (v[i] - w[i]) * (v[i] - w[i]); });
    }
    return sum;
  }
  const KnownState& start = step.states.front();
  const KnownState& end = step.states.back();
  const double last = start.time + step.dt;
  std::vector<double> way(local_, 0.0);  // of the driven ends
  if (relative) {
    way = places_of(ends_, last, local_);
    const std::vector<double> before = places_of(ends_, start.time, local_);
    for (std::size_t i = 0; i < local_; ++i) way[i] -= before[i];
  }
  if (step.work->form == WorkSum::Form::EndMean) {
    const std::vector<double> at_start = rates(start.time), at_end = rates(last);
    for_each([&](std::size_t i) {
      return (end.u[i] - start.u[i] - way[i]) * (start.v[i] - at_start[i] + end.v[i] - at_end[i]) / 2;
    });
  } else {
    const Memory& stage = memory(step.step);
    for_each(
        [&](std::size_t i) { return (end.u[i] - start.u[i] - way[i]) * (stage.row(i, end.u) - way[i]) / step.dt; });
  }
  return sum;
}

StepWork Dashpots::accept(const AcceptedStep& step, TermHistories&) const {
  const double sum = dissipated(step, true);
  return {sum, sum - dissipated(step, false)};
}

}  // namespace ixos
