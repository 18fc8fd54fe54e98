#include "term/support/springs.hpp"

#include <utility>

#include "discretization/coarse_space.hpp"
#include "term/support/diagonal_places.hpp"

namespace ixos {
namespace {

/// A rule's force on a spring is that at one mean displacement.
struct MeanPlace {
  double from = 0, velocity = 0, to = 0;
};

MeanPlace mean_place(const Rule& rule) {
  if (rule.mean != Mean::Points) return {0.5, 0, 0.5};  // exact for a quadratic energy
  MeanPlace mean;
  for (const RulePoint& point : rule.points) {
    mean.from += point.weight * point.from;
    mean.velocity += point.weight * point.velocity;
    mean.to += point.weight * point.to;
  }
  return mean;
}

/// K times a vector, K diagonal. It has no mass to apply.
class SpringAction final : public TangentAction {
 public:
  SpringAction(const DrivenEnds& ends, double& factor) : ends_(ends), factor_(factor) {}
  void linearize(const Segment&, const Rule& rule, Tangent, const LinearPart&) override {
    factor_ = mean_place(rule).to;
  }
  bool applies_mass() const override { return true; }
  void add_product(const double* x, double* y) const override {
    for (std::size_t k = 0; k < ends_.dofs.size(); ++k)
      y[ends_.dofs[k]] += factor_ * ends_.coefficients[k] * x[ends_.dofs[k]];
  }
  void add_diagonal(double* d) const override {
    for (std::size_t k = 0; k < ends_.dofs.size(); ++k) d[ends_.dofs[k]] += factor_ * ends_.coefficients[k];
  }
  bool has_coarse() const override { return true; }
  void add_coarse(const CoarseSpace& coarse, double* values) const override {
    std::vector<double> diagonal(coarse.fine_local(), 0.0);
    add_diagonal(diagonal.data());
    coarse.add_diagonal(diagonal.data(), values);
  }

 private:
  const DrivenEnds& ends_;
  double& factor_;
};

}  // namespace

void add_to_border(double factor, const DrivenEnds& ends, Border& border) {
  for (std::size_t k = 0; k < ends.dofs.size(); ++k) {
    if (ends.dofs[k] < ends.first_global) continue;
    const auto global = static_cast<std::size_t>(ends.dofs[k] - ends.first_global);
    if (border.has(global)) border.entry(global, global) += factor * ends.coefficients[k];
  }
}

std::vector<double> places_of(const DrivenEnds& ends, double time, std::size_t local) {
  std::vector<double> w(local, 0.0);
  ends.to->set(time, w.data(), nullptr, nullptr);
  return w;
}

std::vector<double> rates_of(const DrivenEnds& ends, double time, std::size_t local) {
  std::vector<double> rate(local, 0.0);
  ends.to->set(time, nullptr, rate.data(), nullptr);
  return rate;
}

Springs::Springs(DrivenEnds ends, const Pattern& pattern, std::size_t local)
    : ends_(std::move(ends)),
      owned_(owned_dofs(pattern)),
      local_(local),
      places_(diagonal_places(ends_.dofs, pattern, ends_.first_global)) {}

void Springs::place(const Pattern& pattern) { places_ = diagonal_places(ends_.dofs, pattern, ends_.first_global); }

bool Springs::add_force(const Segment& segment, const Rule& rule, double* f) const {
  const MeanPlace mean = mean_place(rule);
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k) {
    const int i = ends_.dofs[k];
    double u = mean.to * segment.to[i];
    if (mean.from != 0) u += mean.from * segment.from[i];
    if (mean.velocity != 0) u += mean.velocity * segment.velocity[i];
    f[i] += ends_.coefficients[k] * u;
  }
  return true;
}

void Springs::add_tangent(const Segment&, const Rule& rule, Tangent, double* values) const {
  tangent_factor_ = mean_place(rule).to;
  add_to_places(tangent_factor_, ends_.coefficients, places_, values);
}

std::unique_ptr<TangentAction> Springs::create_action() const {
  return std::make_unique<SpringAction>(ends_, tangent_factor_);
}

bool Springs::add_row_sums(const Segment&, double* sums) const {
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k) sums[ends_.dofs[k]] += ends_.coefficients[k];
  return true;
}

double Springs::energy(const Place& at) const {
  double sum = 0;
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k)
    if (const auto i = static_cast<std::size_t>(ends_.dofs[k]); counts(ends_, i, owned_))
      sum += ends_.coefficients[k] * at.u[i] * at.u[i] / 2;
  return sum;
}

double Springs::stretch_energy(double time, const double* u) const {
  const std::vector<double> w = places_of(ends_, time, local_);
  double sum = 0;
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k)
    if (const auto i = static_cast<std::size_t>(ends_.dofs[k]); counts(ends_, i, owned_))
      sum += ends_.coefficients[k] * w[i] * (w[i] / 2 - u[i]);
  return sum;
}

void Springs::add_stretch_gradient(double time, double* f) const {
  const std::vector<double> w = places_of(ends_, time, local_);
  for (std::size_t k = 0; k < ends_.dofs.size(); ++k) {
    const auto i = static_cast<std::size_t>(ends_.dofs[k]);
    f[i] -= ends_.coefficients[k] * w[i];
  }
}

StepWork Springs::accept(const AcceptedStep& step, TermHistories&) const {
  const double start = step.states.front().time;
  return {0, stretch_energy(start + step.dt, step.states.back().u) - stretch_energy(start, step.states.front().u)};
}

}  // namespace ixos
