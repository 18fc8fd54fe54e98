#include "verification/spectral_cases.hpp"

#include <cmath>

#include "support/scene_text.hpp"

namespace ixos::test {
namespace {

using Complex = std::complex<double>;

/// Roots of x^2 - p x + q.
Roots quadratic(double p, double q) {
  const Complex half_width = std::sqrt(Complex(p * p / 4 - q));
  return {p / 2 + half_width, p / 2 - half_width};
}

/// Roots of c3 x^3 + c2 x^2 + c1 x + c0, by Cardano's formula.
Roots cubic(double c3, double c2, double c1, double c0) {
  const double b = c2 / c3, c = c1 / c3, d = c0 / c3;
  const double d0 = b * b - 3 * c, d1 = 2 * b * b * b - 9 * b * c + 27 * d;
  const Complex root = std::sqrt(Complex(d1 * d1 - 4 * d0 * d0 * d0));
  const Complex first = std::pow((d1 + (d1 > 0 ? root : -root)) / 2.0, 1.0 / 3);
  if (first == 0.0) return {-b / 3, -b / 3, -b / 3};
  Roots roots;
  for (int k = 0; k < 3; ++k) {
    const Complex turned = first * std::polar(1.0, 2 * M_PI * k / 3);
    roots.push_back(-(b + turned + d0 / turned) / 3.0);
  }
  return roots;
}

/// Both roots are R(i omega dt) and its conjugate where the scheme is a Runge-Kutta method of stability function R.
Roots conjugates(Complex value) { return {value, std::conj(value)}; }

Roots trapezoid_roots(double x) { return conjugates(Complex(1, x / 2) / Complex(1, -x / 2)); }

// Zienkiewicz 1977, for beta = 0 too.
Roots newmark_roots(double beta, double gamma, double x) {
  const double z = x * x / (1 + beta * x * x);
  return quadratic(2 - (gamma + 0.5) * z, 1 - (gamma - 0.5) * z);
}

// The determinant is 1 for any r = gamma/beta.
Roots composite_roots(double r, double x) { return quadratic(2 - r * x * x / (r + x * x / 2), 1); }

Roots bathe_roots(double rho, double split, double x) {
  const double q1 = (rho + 1) / (2 * split * (rho - 1) + 4);
  const double q0 = (split - 1) * q1 + 0.5;
  const double q2 = 0.5 - split * q1;
  const Complex z(0, x);
  const Complex first = (1.0 + split / 2 * z) / (1.0 - split / 2 * z);
  return conjugates((1.0 + q0 * z + q1 * z * first) / (1.0 - q2 * z));
}

/// Of D (x - 1)^2 + (omega dt)^2 F N = 0 with D = (1 - a_m) x + a_m and F = (1 - a_f) x + a_f; Newmark's kinematics are
/// (x - 1)^2 u = N dt^2 a, N = beta x^2 + (gamma + 1/2 - 2 beta) x + 1/2 - gamma + beta.
Roots alpha_roots(double a_m, double a_f, double beta, double gamma, double omega_dt) {
  const double z = omega_dt * omega_dt;
  const double n1 = gamma + 0.5 - 2 * beta, n0 = 0.5 - gamma + beta;
  return cubic(1 - a_m + z * (1 - a_f) * beta, 3 * a_m - 2 + z * ((1 - a_f) * n1 + a_f * beta),
               1 - 3 * a_m + z * ((1 - a_f) * n0 + a_f * n1), a_m + z * a_f * n0);
}

Roots generalized_alpha_roots(double rho, double x) {
  // The same parameters in terms of s = 1 - a_m + a_f.
  const double s = 2 / (rho + 1);
  return alpha_roots(2 - 1.5 * s, 1 - s / 2, s * s / 4, s - 0.5, x);
}

Roots hht_roots(double alpha, double x) { return alpha_roots(0, -alpha, std::pow((1 - alpha) / 2, 2), 0.5 - alpha, x); }

/// Those of the library's defaults come without parameters.
Case with_defaults(Case one) {
  one.parameters.clear();
  return one;
}

}  // namespace

Case newmark(double beta, double gamma, double at_infinity, double critical) {
  return {"Newmark",
          number("Beta", beta) + number("Gamma", gamma),
          [=](double x) { return newmark_amplification(beta, gamma, x); },
          [=](double x) { return newmark_roots(beta, gamma, x); },
          at_infinity,
          critical};
}

Case bathe(double rho, double split) {
  const double chosen = split != 0 ? split : equal_tangents_split(rho);
  return {"Bathe Composite", number("Spectral Radius", rho) + number("Split", split),
          [=](double x) { return bathe_amplification(rho, chosen, x); },
          [=](double x) { return bathe_roots(rho, chosen, x); }, rho};
}

Case composite(double beta, double gamma, double at_infinity, double critical) {
  return {"Gautam-Sauer Composite",
          number("Beta", beta) + number("Gamma", gamma),
          [=](double x) { return composite_amplification(beta, gamma, x); },
          [=](double x) { return composite_roots(gamma / beta, x); },
          at_infinity,
          critical};
}

Case trapezoid(const std::string& scheme, const std::string& parameters) {
  return {scheme, parameters, trapezoid_amplification, trapezoid_roots, 1};
}

Case generalized_alpha(double rho) {
  return {"Generalized-Alpha", number("Spectral Radius", rho),
          [=](double x) { return generalized_alpha_amplification(rho, x); },
          [=](double x) { return generalized_alpha_roots(rho, x); }, rho};
}

Case hht(double alpha) {
  // At infinity F N = 0, N with the double root -(1 + alpha)/(1 - alpha), the larger one.
  return {"HHT-Alpha", number("Alpha", alpha), [=](double x) { return hht_amplification(alpha, x); },
          [=](double x) { return hht_roots(alpha, x); }, (1 + alpha) / (1 - alpha)};
}

Case central_difference() {
  return {"Central Difference",
          "",
          central_difference_amplification,
          [](double x) { return newmark_roots(0, 0.5, x); },
          unbounded,
          2};
}

const std::vector<Case>& cases() {
  // Newmark at infinity: the larger root of N above; stable up to 1/sqrt(gamma/2 - beta) (Hughes 1987). The composite,
  // r = gamma/beta: of x^2 + 2 (r - 1) x + 1; up to sqrt(4 r/(r - 2)).
  static const std::vector<Case> all{with_defaults(newmark(0.25, 0.5, 1)),
                                     newmark(0.3025, 0.6, 0.9 / 1.1),
                                     newmark(0.4225, 0.8, 0.7 / 1.3),
                                     newmark(0.4, 0.8, 1),
                                     newmark(1.0 / 6, 0.5, 2 + std::sqrt(3.0), std::sqrt(12.0)),
                                     with_defaults(bathe(0, 0.5)),
                                     bathe(0.5, 0),
                                     bathe(0.8, 0.4),
                                     bathe(0.3, 0.7),
                                     bathe(1, 0.5),
                                     with_defaults(composite(0.25, 0.5, 1)),
                                     composite(0.3, 0.6, 1),
                                     composite(0.5, 0.75, 1),
                                     composite(0.25, 0.75, 2 + std::sqrt(3.0), std::sqrt(12.0)),
                                     trapezoid("Average Vector Field"),
                                     trapezoid("Average Vector Field", count("Elastic Points", 1)),
                                     trapezoid("Energy-Momentum"),
                                     with_defaults(generalized_alpha(0.5)),
                                     generalized_alpha(0),
                                     generalized_alpha(0.8),
                                     generalized_alpha(1),
                                     with_defaults(hht(-0.05)),
                                     hht(0),
                                     hht(-0.15),
                                     hht(-1.0 / 3),
                                     trapezoid("Midpoint"),
                                     central_difference()};
  return all;
}

std::string name(const Case& one) {
  const std::string before = "value=\"";
  std::string result = one.scheme;
  for (std::size_t at = one.parameters.find(before); at != std::string::npos; at = one.parameters.find(before, at)) {
    at += before.size();
    result += " " + one.parameters.substr(at, one.parameters.find('"', at) - at);
  }
  return result;
}

}  // namespace ixos::test
