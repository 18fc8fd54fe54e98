#include "time/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace ixos {
namespace {

void expect(const Table& table, std::size_t stage, const char* what, int degree, double found, double wanted,
            double magnitude) {
  if (std::abs(found - wanted) < 1e-13 * (1 + magnitude)) return;
  throw std::invalid_argument(fmt::format("scheme \"{}\", stage {}: the {} gives {} for u = t^{}, not {}", table.name,
                                          stage + 1, what, found, degree, wanted));
}

}  // namespace

void check(const Table& table) {
  std::vector<double> times{0.0};
  for (std::size_t s = 0; s < table.stages.size(); ++s) {
    const Stage& stage = table.stages[s];
    for (const Rule* rule : {&stage.elastic, &stage.interaction})
      if (std::abs(rule->total_weight() - 1) > 1e-12)
        throw std::invalid_argument(fmt::format("scheme \"{}\", stage {}: a rule's weights sum to {}, not 1",
                                                table.name, s + 1, rule->total_weight()));
    const double c = stage.end;
    for (int degree = 0; degree <= 2; ++degree) {
      const double first = degree == 0 ? 0.0 : degree == 1 ? 1.0 : 2 * c;
      const double second = degree == 2 ? 2.0 : 0.0;
      expect(table, s, "velocity row", degree, stage.velocity.on_monomial(degree, c, times), first,
             stage.velocity.magnitude());
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
