#include <utility>

#include "fem/row_on_states.hpp"
#include "model/diagonal_places.hpp"
#include "model/springs.hpp"

namespace ixos {

Dashpots::Dashpots(DrivenEnds ends, const Pattern& pattern, std::size_t local)
    : ends_(std::move(ends)),
      owned_(owned_dofs(pattern)),
      local_(local),
      places_(diagonal_places(ends_.dofs, pattern)) {}

void Dashpots::place(const Pattern& pattern) { places_ = diagonal_places(ends_.dofs, pattern); }

void Dashpots::begin_step(const KnownState&, double time, double dt) {
  time_ = time;
  dt_ = dt;
  stage_ends_.clear();
}

void Dashpots::begin_stage(const StageStart& start) {
  unknown_ = start.damping->unknown;
  from_ = start.known.front().u;
  known_.resize(local_);
  evaluate_known(*start.damping, start.known, start.dt, known_);
  stage_ends_.resize(start.known.size() - 1);  // a stage may begin again
  stage_ends_.push_back(start.time + start.length);
}

/// Returns dt times the velocity that c multiplies.
double Dashpots::row(std::size_t dof, const double* u) const { return unknown_ * (u[dof] - from_[dof]) + known_[dof]; }

void Dashpots::add_force(const double* u, double* f) const {
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k) {
    const auto i = static_cast<std::size_t>(ends_.dofs[k]);
    f[i] += ends_.coefficients[k] * row(i, u) / dt_;
  }
}

void Dashpots::add_tangent(const double*, double* values) const {
  add_to_places(unknown_ / dt_, ends_.coefficients, places_, values);
}

double Dashpots::potential(const double* u) const {
  double sum = 0;
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k)
    if (const auto i = static_cast<std::size_t>(ends_.dofs[k]); i < owned_)
      sum += ends_.coefficients[k] * row(i, u) * row(i, u);
  return sum / (2 * unknown_ * dt_);
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
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k) d[ends_.dofs[k]] += factor * ends_.coefficients[k];
}

/// Returns the work of c v on u, or with `relative` that of c (v - w') on u - w, as the scheme sums it.
double Dashpots::dissipated(const AcceptedStep& step, bool relative) const {
  const bool stages = step.work->form == WorkSum::Form::Stages;
  double sum = 0;
  const auto for_each = [&](const auto& work) {
    for (std::size_t k = 0; k < ends_.dofs.size(); ++k)
      if (const auto i = static_cast<std::size_t>(ends_.dofs[k]); i < owned_) sum += ends_.coefficients[k] * work(i);
  };
  const auto rates = [&](double time) {
    return relative ? rates_of(ends_, time, local_) : std::vector<double>(local_, 0.0);
  };
  if (stages) {
    for (std::size_t s = 0; s < step.states.size(); ++s) {
      const double* v = step.states[s].v;
      const double weight = step.dt * step.work->weights[s];
      const std::vector<double> w = rates(s == 0 ? time_ : stage_ends_[s - 1]);
      for_each([&](std::size_t i) { return weight * (v[i] - w[i]) * (v[i] - w[i]); });
    }
    return sum;
  }
  const KnownState& start = step.states.front();
  const KnownState& end = step.states.back();
  std::vector<double> way(local_, 0.0);  // of the driven ends
  if (relative) {
    way = places_of(ends_, time_ + dt_, local_);
    const std::vector<double> before = places_of(ends_, time_, local_);
    for (std::size_t i = 0; i < local_; ++i) way[i] -= before[i];
  }
  if (step.work->form == WorkSum::Form::EndMean) {
    const std::vector<double> first = rates(time_), last = rates(time_ + dt_);
    for_each([&](std::size_t i) {
      return (end.u[i] - start.u[i] - way[i]) * (start.v[i] - first[i] + end.v[i] - last[i]) / 2;
    });
  } else {
    for_each([&](std::size_t i) { return (end.u[i] - start.u[i] - way[i]) * (row(i, end.u) - way[i]) / step.dt; });
  }
  return sum;
}

double Dashpots::accept(const AcceptedStep& step) {
  const double sum = dissipated(step, true);
  work_ = sum - dissipated(step, false);
  return sum;
}

}  // namespace ixos
