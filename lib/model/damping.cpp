#include "model/damping.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ixos {
namespace {

/// Returns the rule for the tangent of the undeformed body, times `factor`.
Rule rest_rule(double factor) {
  Rule rule = end_rule();
  rule.points[0].weight = factor;
  return rule;
}

}  // namespace

Damping::Damping(const Pattern& pattern, int dimension, int local)
    : pattern_(pattern), dimension_(static_cast<std::size_t>(dimension)), rest_(static_cast<std::size_t>(local), 0.0) {}

void Damping::add_mass(double alpha_1, std::unique_ptr<Mass> mass) { masses_.push_back({alpha_1, std::move(mass)}); }

void Damping::add_stiffness(double alpha_2, const Term& term) { stiffnesses_.push_back({alpha_2, &term, nullptr}); }

void Damping::do_without_matrix() {
  keeps_matrix_ = false;
  product_.resize(rest_.size());
  for (StiffnessPart& part : stiffnesses_) {
    part.action = part.term->create_action();
    if (!part.action) throw std::logic_error("a term of the damping cannot be applied without a matrix");
    part.action->linearize({nullptr, nullptr, rest_.data()}, rest_rule(part.alpha), Tangent::Exact, {});
  }
}

void Damping::multiply_add(double factor, const double* x, double* y) const {
  if (keeps_matrix_) return multiply_add_matrix(factor, x, y);
  multiply_add_mass(factor, x, y);
  if (stiffnesses_.empty()) return;
  std::fill(product_.begin(), product_.end(), 0.0);
  for (const StiffnessPart& part : stiffnesses_) part.action->add_product(x, product_.data());
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
  pattern_.for_each_row(matrix().data(), [&](int row, const auto& entries) {
    double sum = 0;
    entries([&](int column, double value) { sum += value * x[column]; });
    y[row] += factor * sum;
  });
}

void Damping::row_sums(double* sums) const {
  if (!keeps_matrix_) throw std::logic_error("the damping does without its matrix");
  pattern_.for_each_row(matrix().data(), [&](int row, const auto& entries) {
    sums[row] = 0;
    entries([&](int /*column*/, double value) { sums[row] += std::abs(value); });
  });
}

void Damping::add_to(double factor, double* values) const {
  if (!keeps_matrix_) return assemble(factor, values);
  const std::vector<double>& kept = matrix();
  for (std::size_t k = 0; k < kept.size(); ++k) values[k] += factor * kept[k];
}

const std::vector<double>& Damping::matrix() const {
  if (!matrix_.empty()) return matrix_;
  matrix_.assign(static_cast<std::size_t>(pattern_.pairs()) * dimension_ * dimension_, 0.0);
  assemble(1.0, matrix_.data());
  return matrix_;
}

void Damping::assemble(double factor, double* values) const {
  for (const MassPart& part : masses_) part.mass->add_to(factor * part.alpha, values);
  for (const StiffnessPart& part : stiffnesses_)
    part.term->add_tangent({nullptr, nullptr, rest_.data()}, rest_rule(factor * part.alpha), Tangent::Exact, values);
}

}  // namespace ixos
