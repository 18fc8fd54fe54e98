#include "model/term_sums.hpp"

#include <algorithm>

namespace ixos {

template <class Visit>
void TermSums::for_each(Part part, const Visit& visit) const {
  for (const NamedForceTerm& named : model_.force_terms())
    if (named.term->part() == part) visit(*named.term);
}

bool TermSums::force(Part part, const Segment& segment, const Rule& rule, double* f) const {
  std::fill_n(f, model_.space().local(), 0.0);
  bool admissible = true;
  for_each(part, [&](const ForceTerm& term) { admissible = term.add_force(segment, rule, f) && admissible; });
  model_.space().condense(f);
  return admissible;
}

KeptForces TermSums::create_kept() const {
  KeptForces kept;
  for (const NamedForceTerm& named : model_.force_terms()) kept.push_back(named.term->create_kept());
  return kept;
}

bool TermSums::force_and_keep(Part part, const Segment& segment, const Rule& rule, KeptForces& kept, double* f) const {
  std::fill_n(f, model_.space().local(), 0.0);
  const std::vector<NamedForceTerm>& terms = model_.force_terms();
  kept.resize(terms.size());  // terms that were added later keep nothing
  bool admissible = true;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const ForceTerm& term = *terms[i].term;
    if (term.part() != part) continue;
    const bool good = kept[i] ? term.add_force_and_keep(segment, rule, *kept[i], f) : term.add_force(segment, rule, f);
    admissible = admissible && good;
  }
  model_.space().condense(f);
  return admissible;
}

void TermSums::add_kept_tangent(Part part, const Segment& segment, const Rule& rule, Tangent kind,
                                const KeptForces& kept, double* values) const {
  const std::vector<NamedForceTerm>& terms = model_.force_terms();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const ForceTerm& term = *terms[i].term;
    if (term.part() != part) continue;
    if (kept[i])
      term.add_kept_tangent(segment, rule, kind, *kept[i], values);
    else
      term.add_tangent(segment, rule, kind, values);
  }
}

void TermSums::add_tangent(Part part, const Segment& segment, const Rule& rule, Tangent kind, double* values) const {
  for_each(part, [&](const ForceTerm& term) { term.add_tangent(segment, rule, kind, values); });
}

std::vector<std::unique_ptr<TangentAction>> TermSums::actions(Part part) const {
  std::vector<std::unique_ptr<TangentAction>> result;
  for_each(part, [&](const ForceTerm& term) { result.push_back(term.create_action()); });
  return result;
}

std::vector<LinearPart> TermSums::linear_parts(double mass, double damping) const {
  std::vector<LinearPart> parts(model_.bodies().size());
  for (std::size_t i = 0; i < parts.size() && model_.mass() != nullptr; ++i) {
    const Material& material = model_.bodies()[i].material;
    parts[i] = {damping * material.stiffness_damping, (mass + damping * material.mass_damping) * material.density};
  }
  return parts;
}

bool TermSums::add_row_sums(Part part, const Segment& segment, double* sums) const {
  bool admissible = true;
  for_each(part, [&](const ForceTerm& term) { admissible = term.add_row_sums(segment, sums) && admissible; });
  condense_row_sums(sums);
  return admissible;
}

void TermSums::add_rate_force(const Place& at, double* f) const {
  for (const RateTerm* term : model_.rate_terms()) term->add_force(at, f);
  model_.space().condense(f);
}

void TermSums::add_rate_tangent(const Place& at, double* values) const {
  for (const RateTerm* term : model_.rate_terms()) term->add_tangent(at, values);
}

double TermSums::rate_potential(const Place& at) const {
  double sum = 0;
  for (const RateTerm* term : model_.rate_terms()) sum += term->potential(at);
  return sum;
}

void TermSums::add_rate_force_at(double factor, const double* u, const double* v, double* f) const {
  for (const RateTerm* term : model_.rate_terms()) term->add_force_at(factor, u, v, f);
  model_.space().condense(f);
}

void TermSums::add_rate_tangent_at(double by_velocity, double by_displacement, const double* u, const double* v,
                                   double* values) const {
  for (const RateTerm* term : model_.rate_terms()) term->add_tangent_at(by_velocity, by_displacement, u, v, values);
}

bool TermSums::has_diagonal_rates() const {
  const auto& terms = model_.rate_terms();
  return std::all_of(terms.begin(), terms.end(),
                     [&](const RateTerm* term) { return term->is_diagonal() || term == model_.damping(); });
}

std::vector<double> TermSums::rate_diagonal(double factor) const {
  std::vector<double> d;
  for (const RateTerm* term : model_.rate_terms()) {
    if (!term->is_diagonal()) continue;
    d.resize(static_cast<std::size_t>(model_.space().local()));
    term->add_diagonal(factor, d.data());
  }
  return d;
}

void TermSums::add_rate_row_sums(const double* u, double* sums) const {
  for (const RateTerm* term : model_.rate_terms()) term->add_row_sums(u, sums);
  condense_row_sums(sums);
}

void TermSums::condense_row_sums(double* sums) const {
  const NodeTies& ties = model_.space().ties();
  ties.condense_magnitudes(sums, static_cast<std::size_t>(model_.mesh().dimension));
}

double TermSums::potential(Part part, const Rule& rule, const Place& at) const {
  double sum = 0;
  if (part == Part::Elastic) for_each(part, [&](const ForceTerm& term) { sum += term.potential(at); });
  if (part == Part::Interaction)
    for (const NamedInteraction& named : model_.interactions())
      if (named.term->followed(rule).mean == Mean::Points) sum += named.term->potential(at);
  return sum;
}

double TermSums::mean_potential(const Segment& segment, const Rule& rule) const {
  double sum = 0;
  for (const NamedInteraction& named : model_.interactions())
    if (named.term->followed(rule).mean == Mean::Exact) sum += named.term->mean_potential(segment);
  return sum;
}

double TermSums::rounding(const Place& at) const {
  double sum = 0;
  for (const NamedInteraction& named : model_.interactions()) sum += named.term->rounding(at);
  return sum;
}

double TermSums::admissible_step(const Segment& segment, const Rule& interaction, const double* direction) const {
  if (!model_.has_interactions()) return 1.0;
  double step = 1.0;
  for (const NamedInteraction& named : model_.interactions())
    step = std::min(step, named.term->admissibility().admissible_step(segment, interaction, direction));
  return model_.space().minimum(step);
}

double TermSums::gap_ratio(const Segment& way) const {
  double largest = 1;
  for (const NamedInteraction& named : model_.interactions())
    largest = std::max(largest, named.term->admissibility().gap_ratio(way));
  return model_.space().maximum(largest);
}

double TermSums::obstacle_work(const Segment& segment, const Rule& rule) const {
  double sum = 0;
  for (const NamedInteraction& named : model_.interactions())
    if (const ObstacleMotion* motion = named.term->motion()) sum += motion->work(segment, rule);
  model_.space().sum(&sum, 1);
  return sum;
}

void add_to_diagonal(const Pattern& pattern, int dimension, double value, double* values) {
  for (int row = 0; row < pattern.rows(); ++row)
    for (int i = 0; i < dimension; ++i) values[pattern.offset(row, row) + pattern.stride(row) * i + i] += value;
}

}  // namespace ixos
