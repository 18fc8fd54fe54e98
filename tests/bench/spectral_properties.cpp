// Spectral radius, period error and decay of the schemes' amplification matrices over dt/T from 0.01 to 10, as CSV for
// drivers/plot/spectrum.py: a label is the scheme and its parameters; a cell is empty where nothing oscillates.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "support/amplification.hpp"

namespace {

using ixos::test::Amplification;

struct Curve {
  std::string label;
  std::function<Amplification(double)> amplification;  ///< of omega dt
};

std::vector<Curve> curves() {
  using namespace ixos::test;
  std::vector<Curve> all;
  const auto add = [&](const std::string& label, std::function<Amplification(double)> amplification) {
    all.push_back({label, std::move(amplification)});
  };
  add("Newmark", [](double x) { return newmark_amplification(0.25, 0.5, x); });
  add("Gautam-Sauer Composite", [](double x) { return composite_amplification(0.25, 0.5, x); });
  for (const char* scheme : {"Average Vector Field", "Energy-Momentum", "Midpoint"})
    add(scheme, trapezoid_amplification);
  add("Newmark 0.3025 0.6", [](double x) { return newmark_amplification(0.3025, 0.6, x); });
  add("Bathe Composite", [](double x) { return bathe_amplification(0, 0.5, x); });
  for (double rho : {0.5, 0.8})
    add(fmt::format("Bathe Composite {}", rho),
        [=](double x) { return bathe_amplification(rho, equal_tangents_split(rho), x); });
  for (double rho : {0.0, 0.5, 0.8})
    add(fmt::format("Generalized-Alpha {}", rho), [=](double x) { return generalized_alpha_amplification(rho, x); });
  for (double alpha : {-0.05, -0.15})
    add(fmt::format("HHT-Alpha {}", alpha), [=](double x) { return hht_amplification(alpha, x); });
  add("Central Difference", central_difference_amplification);
  return all;
}

std::string cell(double value) { return std::isnan(value) ? "" : fmt::format("{:.12g}", value); }

}  // namespace

int main() {
  constexpr int count = 200;
  fmt::print("scheme,dt_over_T,spectral_radius,period_error,decay\n");
  for (const Curve& curve : curves())
    for (int i = 0; i < count; ++i) {
      const double ratio = std::pow(10, -2 + 3.0 * i / (count - 1));
      const double omega_dt = 2 * M_PI * ratio;
      const auto found =
          ixos::test::spectral_properties(ixos::test::eigenvalues(curve.amplification(omega_dt)), omega_dt);
      fmt::print("{},{:.12g},{:.12g},{},{}\n", curve.label, ratio, found.spectral_radius, cell(found.period_error),
                 cell(found.decay));
    }
  return 0;
}
