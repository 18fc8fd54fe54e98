// Sums over all terms that steps, histories and field files ask for.
#include <algorithm>

#include "model/model.hpp"

namespace ixos {

bool Model::has_moved_obstacles() const {
  return std::any_of(interactions_.begin(), interactions_.end(),
                     [](const Interaction* own) { return own->is_moved(); });
}

bool Model::obstacles_are_finite(double time) const {
  return std::all_of(interactions_.begin(), interactions_.end(),
                     [time](const Interaction* own) { return own->is_finite(time); });
}

bool Model::has_laws_of_every_gap() const {
  return std::any_of(interactions_.begin(), interactions_.end(),
                     [](const Interaction* own) { return !own->needs_positive_gaps(); });
}

void Model::set_time(double time) const {
  time_ = time;
  for (const Interaction* term : interactions_) term->set_time(time);
}

double Model::obstacle_work(const Segment& segment, const Rule& rule) const {
  double sum = 0;
  for (const Interaction* term : interactions_) sum += term->obstacle_work(segment, rule);
  space_.sum(&sum, 1);
  return sum;
}

double Model::admissible_step(const Segment& segment, const Rule& interaction, const double* direction) const {
  if (interactions_.empty()) return 1.0;
  double step = 1.0;
  for (const Interaction* term : interactions_)
    step = std::min(step, term->admissible_step(segment, interaction, direction));
  return space_.minimum(step);
}

double Model::local_mean_potential(const Segment& segment, const Rule& rule) const {
  double sum = 0;
  for (const Interaction* term : interactions_)
    if (term->followed(rule).mean == Mean::Exact) sum += term->mean_potential(segment);
  return sum;
}

double Model::gap_ratio(const double* from, const double* to) const {
  double largest = 1;
  for (const Interaction* term : interactions_) largest = std::max(largest, term->gap_ratio(from, to));
  return space_.maximum(largest);
}

bool Model::has_friction() const {
  return std::any_of(interactions_.begin(), interactions_.end(),
                     [](const Interaction* term) { return term->has_friction(); });
}

double Model::local_rounding(const double* u) const {
  double sum = 0;
  for (const Interaction* term : interactions_) sum += term->rounding(u);
  return sum;
}

InteractionReport Model::interaction_report(const double* u) const { return all_interactions().report(u); }

Momenta Model::momenta(const double* u, const double* v) const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  std::vector<double> momentum(static_cast<std::size_t>(space_.owned()), 0.0);
  if (mass_) mass_->multiply(v, momentum.data());
  std::vector<double> sums(1 + d + (d == 2 ? 1 : 3), 0.0);
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh_.owned_nodes); ++node) {
    const double* p = &momentum[node * d];
    double x[3] = {};
    for (std::size_t i = 0; i < d; ++i) {
      x[i] = mesh_.coordinates[node * d + i] + u[node * d + i];
      sums[0] += 0.5 * v[node * d + i] * p[i];
      if (!mesh_.is_derivative(node)) sums[1 + i] += p[i];
    }
    if (d == 2) {
      sums[3] += x[0] * p[1] - x[1] * p[0];
    } else {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        sums[4 + i] += x[j] * p[k] - x[k] * p[j];
      }
    }
  }
  space_.sum(sums.data(), static_cast<int>(sums.size()));
  if (mesh_.axisymmetric) sums[1] = sums[3] = 0;  // the ring's radial momenta cancel
  const auto first = sums.begin() + 1;
  const auto middle = first + static_cast<std::ptrdiff_t>(d);
  return {sums[0], {first, middle}, {middle, sums.end()}};
}

}  // namespace ixos
