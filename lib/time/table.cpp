#include "time/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fem/quadrature.hpp"

namespace ixos {
namespace {

void expect(const Table& table, std::size_t stage, const char* what, int degree, double found, double wanted,
            double magnitude) {
  if (std::abs(found - wanted) < 1e-13 * (1 + magnitude)) return;
  throw std::invalid_argument(fmt::format("scheme \"{}\", stage {}: the {} gives {} for u = t^{}, not {}", table.name,
                                          stage + 1, what, found, degree, wanted));
}

}  // namespace

Rule mean_rule(int n, Path path) {
  if (n > 0) return gauss_rule(n, path);
  if (path != Path::Linear) throw std::invalid_argument("the exact mean needs the linear path");
  return exact_rule();
}

double quadrature_error(int n, double gap_ratio) {
  if (n == 0 || gap_ratio <= 1) return 0;
  const double root = std::sqrt(gap_ratio), rho = (root + 1) / (root - 1);
  return 1e9 * std::pow(rho, -2 * n);
}

double elastic_quadrature_error(int n, double edge_change) {
  if (n == 0 || edge_change <= 0) return 0;
  const double z = std::max(1.0, 2 / edge_change), rho = z + std::sqrt(z * z - 1);
  return 1e4 * std::pow(rho, -2 * n);
}

std::vector<TimePoint> gauss_times(int n) {
  const Quadrature gauss = gauss_legendre_unit(n > 0 ? n : 8);
  std::vector<TimePoint> times;
  for (std::size_t i = 0; i < gauss.points.size(); ++i) times.push_back({gauss.points[i], gauss.weights[i]});
  return times;
}

bool is_static(const Table& table) {
  return std::all_of(table.stages.begin(), table.stages.end(),
                     [](const Stage& stage) { return stage.inertia.unknown == 0 && stage.inertia.known.empty(); });
}

bool is_explicit(const Table& table) {
  const auto known = [](const Rule& rule) { return rule.points.empty() && rule.mean == Mean::Points; };
  return table.stages.size() == 1 && known(table.stages[0].elastic) && known(table.stages[0].interaction);
}

bool has_exact_rates(const Table& table) {
  return table.closing != Closing::Collocate && table.driven_rates == DrivenRates::Exact;
}

bool have_like_tangents(const Stage& a, const Stage& b) {
  const auto like = [](double x, double y) { return x == y || (x <= 2 * y && y <= 2 * x); };
  return like(a.inertia.unknown, b.inertia.unknown) && like(a.damping.unknown, b.damping.unknown) &&
         like(a.elastic.end_weight(), b.elastic.end_weight()) &&
         like(a.interaction.end_weight(), b.interaction.end_weight());
}

void check(const Table& table) {
  if (table.work.form == WorkSum::Form::Stages && table.work.weights.size() != table.stages.size() + 1)
    throw std::invalid_argument(
        fmt::format("scheme \"{}\": there are {} weights for the work of {} stages; there must be one for the step's "
                    "start and one for each stage",
                    table.name, table.work.weights.size(), table.stages.size()));
  if (is_explicit(table) != (table.closing == Closing::Explicit) ||
      (is_explicit(table) && table.mass != Inertia::Lumped))
    throw std::invalid_argument(
        fmt::format("scheme \"{}\": an explicit table must close explicitly and have a lumped mass", table.name));
  if (is_explicit(table) && table.work.form != WorkSum::Form::EndMean)
    throw std::invalid_argument(
        fmt::format("scheme \"{}\": an explicit table must sum work by the mean of the ends", table.name));
  if (table.stages.back().end != 1)
    throw std::invalid_argument(fmt::format("scheme \"{}\": the last stage ends at {}, not at the step's end, 1",
                                            table.name, table.stages.back().end));
  for (std::size_t s = 0; s + 1 < table.stages.size(); ++s)
    if (!(table.stages[s].end < 1))
      throw std::invalid_argument(
          fmt::format("scheme \"{}\", stage {}: it ends at {}, but only the last stage may end at the step's end, 1",
                      table.name, s + 1, table.stages[s].end));
  const bool no_inertia = is_static(table);
  std::vector<double> times{0.0};
  for (std::size_t s = 0; s < table.stages.size(); ++s) {
    const Stage& stage = table.stages[s];
    for (const Rule* rule : {&stage.elastic, &stage.interaction})
      if (std::abs(rule->total_weight() - 1) > 1e-12)
        throw std::invalid_argument(fmt::format("scheme \"{}\", stage {}: a rule's weights sum to {}, not 1",
                                                table.name, s + 1, rule->total_weight()));
    if (stage.elastic.mean == Mean::Exact)
      throw std::invalid_argument(
          fmt::format("scheme \"{}\", stage {}: elasticity has no exact mean", table.name, s + 1));
    if (stage.rate_form != RateForm::End && (stage.end != 1 || stage.damping.unknown != 1 || stage.rate_start != 0))
      throw std::invalid_argument(
          fmt::format("scheme \"{}\", stage {}: rates in momentum form need a damping row du and a stage that is the "
                      "whole step",
                      table.name, s + 1));
    double load_weight = 0;
    for (const TimePoint& point : stage.load) load_weight += point.weight;
    if (std::abs(load_weight - 1) > 1e-12)
      throw std::invalid_argument(
          fmt::format("scheme \"{}\", stage {}: the load's weights sum to {}, not 1", table.name, s + 1, load_weight));
    const double c = stage.end;
    for (int degree = 0; degree <= 2; ++degree) {
      const double first = degree == 0 ? 0.0 : degree == 1 ? 1.0 : 2 * c;
      const double second = degree == 2 ? 2.0 : 0.0;
      if (no_inertia && degree == 2) continue;
      expect(table, s, "velocity row", degree, stage.velocity.on_monomial(degree, c, times), first,
             stage.velocity.magnitude());
      if (no_inertia) continue;
      expect(table, s, "acceleration row", degree, stage.acceleration.on_monomial(degree, c, times), second,
             stage.acceleration.magnitude());
      expect(table, s, "inertia row", degree, stage.inertia.on_monomial(degree, c, times), second,
             stage.inertia.magnitude());
      // A mean of u' over the step (momentum form) and u' at its end agree up to degree 1 only.
      if (degree < 2)
        expect(table, s, "damping row", degree, stage.damping.on_monomial(degree, c, times), first,
               stage.damping.magnitude());
    }
    times.push_back(c);
  }
}

}  // namespace ixos
