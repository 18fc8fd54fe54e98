#include "term/body/damping.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/dot.hpp"

namespace ixos {

Damping::Damping(const Pattern& pattern, int dimension, int local)
    : pattern_(pattern), dimension_(static_cast<std::size_t>(dimension)), rest_(static_cast<std::size_t>(local), 0.0) {}

void Damping::add_mass(double alpha_1, std::unique_ptr<Mass> mass) { masses_.push_back({alpha_1, std::move(mass)}); }

void Damping::add_stiffness(double alpha_2, const ForceTerm& term) {
  stiffnesses_.push_back({alpha_2, &term, nullptr});
}

void Damping::do_without_matrix() {
  keeps_matrix_ = false;
  product_.resize(rest_.size());
  for (StiffnessPart& part : stiffnesses_) {
    part.action = part.term->create_action();
    if (!part.action) throw std::logic_error("a term of the damping cannot be applied without a matrix");
    part.action->linearize({nullptr, nullptr, rest_.data()}, end_rule(part.alpha), Tangent::Exact, {});
  }
}

void Damping::place(const Pattern&) {
  matrix_.clear();
  for (MassPart& part : masses_) part.mass->place();
}

/// A stage: the damping row.
struct Damping::Memory final : StepMemory {
  double unknown = 0;  ///< the row's coefficient of u
  double dt = 0;
  const double* from = nullptr;  ///< u at the step's start
  const std::vector<int>* driven = nullptr;
  const double* driven_velocity = nullptr;
  std::vector<double> known;  ///< the row without its unknown part, local
};

std::unique_ptr<StepMemory> Damping::create_memory() const { return std::make_unique<Memory>(); }

const Damping::Memory& Damping::memory(const StepMemories* step) const { return step->of<Memory>(slot()); }

void Damping::begin_stage(const StageStart& start, StepMemories& step) const {
  auto& memory = step.of<Memory>(slot());
  memory.unknown = start.damping->unknown;
  memory.dt = start.dt;
  memory.from = start.known.front().u;
  memory.driven = start.driven;
  memory.driven_velocity = start.driven_velocity;
  memory.known.resize(rest_.size());
  evaluate_known(*start.damping, start.known, start.dt, memory.known);
}

void Damping::evaluate_row(const Place& at) const {
  const Memory& stage = memory(at.step);
  row_.resize(rest_.size());
  evaluate(stage.unknown, at.u, stage.from, stage.known, row_);
  if (stage.driven == nullptr) return;
  for (int dof : *stage.driven) row_[static_cast<std::size_t>(dof)] = stage.dt * stage.driven_velocity[dof];
  pattern_.ties().interpolate(row_.data(), dimension_);
}

void Damping::add_force(const Place& at, double* f) const {
  evaluate_row(at);
  multiply_add(1 / memory(at.step).dt, row_.data(), f);
}

void Damping::add_tangent(const Place& at, double* values) const {
  const Memory& stage = memory(at.step);
  add_to(stage.unknown / stage.dt, values);
}

double Damping::potential(const Place& at) const {
  evaluate_row(at);
  const Memory& stage = memory(at.step);
  std::vector<double> force(static_cast<std::size_t>(pattern_.rows()) * dimension_, 0.0);
  multiply_add(1 / stage.dt, row_.data(), force.data());
  return dot(row_, force, force.size()) / (2 * stage.unknown);
}

void Damping::add_force_at(double factor, const double*, const double* v, double* f) const {
  multiply_add(factor, v, f);
}

void Damping::add_tangent_at(double by_velocity, double, const double*, const double*, double* values) const {
  add_to(by_velocity, values);
}

double Damping::work(const std::vector<double>& x, const double* y) const {
  std::vector<double> force(static_cast<std::size_t>(pattern_.rows()) * dimension_, 0.0);
  multiply_add(1.0, y, force.data());
  return dot(x, force, force.size());
}

StepWork Damping::accept(const AcceptedStep& step, TermHistories&) const {
  const KnownState& start = step.states.front();
  const KnownState& end = step.states.back();
  const std::vector<double>& weights = step.work->weights;
  double sum = 0;
  if (step.work->form == WorkSum::Form::Stages) {
    for (std::size_t i = 0; i < step.states.size(); ++i) {
      const double* v = step.states[i].v;
      sum += step.dt * weights[i] * work({v, v + rest_.size()}, v);
    }
    return {sum, 0};
  }
  std::vector<double> du(end.u, end.u + rest_.size());
  for (std::size_t i = 0; i < du.size(); ++i) du[i] -= start.u[i];
  if (step.work->form == WorkSum::Form::EndMean) return {(work(du, start.v) + work(du, end.v)) / 2, 0};
  const Memory& stage = memory(step.step);
  row_.resize(rest_.size());
  evaluate(stage.unknown, end.u, start.u, stage.known, row_);
  return {work(du, row_.data()) / stage.dt, 0};
}

void Damping::multiply_add(double factor, const double* x, double* y) const {
  if (keeps_matrix_) return multiply_add_matrix(factor, x, y);
  multiply_add_mass(factor, x, y);
  if (stiffnesses_.empty()) return;
  std::fill(product_.begin(), product_.end(), 0.0);
  for (const StiffnessPart& part : stiffnesses_) part.action->add_product(x, product_.data());
  pattern_.ties().condense(product_.data(), dimension_);
  for (std::size_t i = 0; i < static_cast<std::size_t>(pattern_.rows()) * dimension_; ++i) y[i] += factor * product_[i];
}

void Damping::multiply_add_mass(double factor, const double* x, double* y) const {
  for (const MassPart& part : masses_) {
    product_.resize(rest_.size());
    part.mass->multiply(x, product_.data());
    for (std::size_t i = 0; i < static_cast<std::size_t>(pattern_.rows()) * dimension_; ++i)
      y[i] += factor * part.alpha * product_[i];
  }
}

void Damping::add_mass_diagonal(double factor, double* d) const {
  for (const MassPart& part : masses_) part.mass->add_diagonal(factor * part.alpha, d);
}

void Damping::multiply_add_matrix(double factor, const double* x, double* y) const {
  add_matrix_product(pattern_, matrix().data(), factor, x, y);
}

void Damping::add_row_sums(const double*, double* sums) const {
  if (!keeps_matrix_) throw std::logic_error("the damping does without its matrix");
  pattern_.for_each_row(matrix().data(), [&](int row, const auto& entries) {
    double sum = 0;
    entries([&](int /*column*/, double value) { sum += std::abs(value); });
    sums[row] += sum;
  });
}

void Damping::add_to(double factor, double* values) const {
  if (!keeps_matrix_) return assemble(factor, values);
  const std::vector<double>& kept = matrix();
  for (std::size_t k = 0; k < kept.size(); ++k) values[k] += factor * kept[k];
}

const std::vector<double>& Damping::matrix() const {
  if (!matrix_.empty()) return matrix_;
  matrix_.assign(pattern_.values(), 0.0);
  assemble(1.0, matrix_.data());
  pattern_.condense(matrix_.data());
  return matrix_;
}

void Damping::assemble(double factor, double* values) const {
  for (const MassPart& part : masses_) part.mass->add_to(factor * part.alpha, values);
  for (const StiffnessPart& part : stiffnesses_)
    part.term->add_tangent({nullptr, nullptr, rest_.data()}, end_rule(factor * part.alpha), Tangent::Exact, values);
}

}  // namespace ixos
