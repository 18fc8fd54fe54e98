#include "balance/derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/traits.hpp"

namespace ixos {

std::vector<TermParameter> BalanceDerivatives::parameters() const {
  std::vector<TermParameter> all;
  for (const NamedForceTerm& named : model_.force_terms())
    for (const std::string& name : named.term->parameters()) {
      const auto same = [&](const TermParameter& other) { return other.term == named.name && other.name == name; };
      if (!has_friction(model_, named.name) && std::none_of(all.begin(), all.end(), same))
        all.push_back({named.name, name});
    }
  return all;
}

/// Cells or sides of several kinds have terms of one name.
bool BalanceDerivatives::by_parameter(const BalancePoint& at, const TermParameter& parameter, double* df) const {
  if (at.rates != Rates::None && !model_.rate_terms().empty())
    throw std::logic_error("damping forces have no derivatives by numbers of terms");
  std::fill_n(df, model_.space().local(), 0.0);
  bool found = false, admissible = true;
  for (const NamedForceTerm& named : model_.force_terms()) {
    if (named.name != parameter.term || has_friction(model_, named.name)) continue;
    const std::vector<std::string> names = named.term->parameters();
    for (std::size_t number = 0; number < names.size(); ++number) {
      if (names[number] != parameter.name) continue;
      found = true;
      admissible = named.term->add_parameter_derivative(number, segment(at, *named.term), rule(at, *named.term), df) &&
                   admissible;
    }
  }
  if (!found)
    throw std::logic_error("the model has no number \"" + parameter.name + "\" of \"" + parameter.term + "\"");
  model_.space().condense(df);
  return admissible;
}

/// The times around which values are compared with rates are not known: one of several spans has to fit.
bool BalanceDerivatives::loads_know_rates(double time, double span) const {
  const auto local = static_cast<std::size_t>(model_.space().local());
  const auto largest = [](const std::vector<double>& x) {
    double result = 0;
    for (const double value : x) result = std::max(result, std::abs(value));
    return result;
  };
  std::vector<double> rate(local, 0.0), force(local, 0.0);
  model_.loads().add_rate(time, 1, rate.data());
  model_.loads().add_force(time, 1, force.data());
  bool known = false;
  for (const double share : {1e-3, 1e-6, 1e-9}) {
    const double h = share * span;
    std::vector<double> change(local, 0.0);
    model_.loads().add_force(time + h, 0.5 / h, change.data());
    model_.loads().add_force(time - h, -0.5 / h, change.data());
    const double size = largest(change), rounding = 1e-15 * largest(force) / h;
    for (std::size_t i = 0; i < local; ++i) change[i] -= rate[i];
    known = known || largest(change) <= 1e-2 * size + rounding;
  }
  return model_.space().minimum(known ? 1 : 0) > 0;
}

bool BalanceDerivatives::has_time_derivative(const BalancePoint& at) const {
  const std::vector<NamedForceTerm>& terms = model_.force_terms();
  const bool has_terms = std::all_of(terms.begin(), terms.end(), [&](const NamedForceTerm& named) {
    return named.term->has_time_derivative(rule(at, *named.term));
  });
  const double end = at.elastic.start + at.elastic.length;
  return has_terms && loads_know_rates(end, at.elastic.length > 0 ? at.elastic.length : 1 + std::abs(end));
}

void BalanceDerivatives::by_time(const BalancePoint& at, double* df) const {
  if (!has_time_derivative(at)) throw std::logic_error("a term or a load has no derivative by time");
  std::fill_n(df, model_.space().local(), 0.0);
  for (const NamedForceTerm& named : model_.force_terms())
    named.term->add_time_derivative(segment(at, *named.term), rule(at, *named.term), df);
  model_.space().condense(df);
  model_.loads().add_rate(at.elastic.start + at.elastic.length, -1, df);
}

}  // namespace ixos
