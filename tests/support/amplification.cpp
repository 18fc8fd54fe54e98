#include "support/amplification.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ixos::test {
namespace {

using Rows = std::vector<std::vector<double>>;

Amplification matrix(const Rows& rows) {
  Amplification result(static_cast<int>(rows.size()), static_cast<int>(rows.front().size()));
  for (int i = 0; i < result.numRows(); ++i)
    for (int j = 0; j < result.numCols(); ++j)
      result(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return result;
}

/// The last rows of X in `left` X = `right`, as many as X has columns: the scheme's equations give intermediate states
/// first and the end of the step last.
Amplification solved(const Rows& left, const Rows& right) {
  Amplification a = matrix(left);
  Amplification x = matrix(right);
  const int n = a.numRows();
  const int size = x.numCols();
  std::vector<int> pivots(left.size());
  int info = 0;
  Teuchos::LAPACK<int, double>().GESV(n, size, a.values(), a.stride(), pivots.data(), x.values(), x.stride(), &info);
  if (info != 0) throw std::runtime_error("the scheme's equations are singular");
  return {Teuchos::Copy, x, size, size, n - size, 0};
}

/// Newmark's kinematics, and balance with the inertia weighted by 1 - a_m, a_m between the end and the start of the
/// step, the force by 1 - a_f, a_f.
Amplification alpha_method(double a_m, double a_f, double beta, double gamma, double omega_dt) {
  const double z = omega_dt * omega_dt;
  return solved({{1, 0, -beta},  //
                 {0, 1, -gamma},
                 {(1 - a_f) * z, 0, 1 - a_m}},
                {{1, 1, 0.5 - beta},  //
                 {0, 1, 1 - gamma},
                 {-a_f * z, 0, -a_m}});
}

}  // namespace

Amplification newmark_amplification(double beta, double gamma, double omega_dt) {
  return alpha_method(0, 0, beta, gamma, omega_dt);
}

double equal_tangents_split(double rho) { return (2 - std::sqrt(2 + 2 * rho)) / (1 - rho); }

Amplification bathe_amplification(double rho, double split, double omega_dt) {
  const double z = omega_dt * omega_dt;
  const double h = split / 2;
  const double q1 = (rho + 1) / (2 * split * (rho - 1) + 4);
  const double q0 = (split - 1) * q1 + 0.5;
  const double q2 = -split * q1 + 0.5;
  return solved({{1, -h, 0, 0, 0, 0},  // trapezoid to t_n + split dt
                 {0, 1, -h, 0, 0, 0},
                 {z, 0, 1, 0, 0, 0},
                 {0, -q1, 0, 1, -q2, 0},  // to t_n + dt
                 {0, 0, -q1, 0, 1, -q2},
                 {0, 0, 0, z, 0, 1}},
                {{1, h, 0},  //
                 {0, 1, h},
                 {0, 0, 0},
                 {1, q0, 0},
                 {0, 1, q0},
                 {0, 0, 0}});
}

Amplification composite_amplification(double beta, double gamma, double omega_dt) {
  const double z = omega_dt * omega_dt;
  const double r = gamma / beta;
  return solved({{-r, 1}, {z / 2, 1}}, {{-r - (1 - r / 2) * z, 1 - r}, {-z / 2, 1}});
}

Amplification trapezoid_amplification(double omega_dt) {
  const double z = omega_dt * omega_dt;
  return solved({{1, -0.5}, {z / 2, 1}}, {{1, 0.5}, {-z / 2, 1}});
}

Amplification generalized_alpha_amplification(double rho, double omega_dt) {
  const double a_m = (2 * rho - 1) / (rho + 1);
  const double a_f = rho / (rho + 1);
  const double beta = (1 - a_m + a_f) * (1 - a_m + a_f) / 4;
  const double gamma = 0.5 - a_m + a_f;
  return alpha_method(a_m, a_f, beta, gamma, omega_dt);
}

Amplification hht_amplification(double alpha, double omega_dt) {
  return alpha_method(0, -alpha, (1 - alpha) * (1 - alpha) / 4, (1 - 2 * alpha) / 2, omega_dt);
}

Amplification central_difference_amplification(double omega_dt) {
  const double z = omega_dt * omega_dt;
  return solved({{1, 0, 0}, {0, 1, -0.5}, {z, 0, 1}}, {{1, 1, 0.5}, {0, 1, 0.5}, {0, 0, 0}});
}

std::vector<std::complex<double>> eigenvalues(const Amplification& amplification) {
  Amplification a = amplification;  // overwritten
  const int n = a.numRows();
  const auto size = static_cast<std::size_t>(n);
  std::vector<double> real(size), imaginary(size), work(8 * size);
  double none = 0;
  int info = 0;
  Teuchos::LAPACK<int, double>().GEEV('N', 'N', n, a.values(), a.stride(), real.data(), imaginary.data(), &none, 1,
                                      &none, 1, work.data(), static_cast<int>(work.size()), &info);
  if (info != 0) throw std::runtime_error("no eigenvalues");
  std::vector<std::complex<double>> result;
  for (std::size_t i = 0; i < size; ++i) result.emplace_back(real[i], imaginary[i]);
  return result;
}

SpectralProperties spectral_properties(const std::vector<std::complex<double>>& eigenvalues, double omega_dt) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SpectralProperties result{0, nan, nan};
  for (const std::complex<double>& value : eigenvalues) {
    result.spectral_radius = std::max(result.spectral_radius, std::abs(value));
    if (value.imag() <= 0) continue;
    result.period_error = omega_dt / std::arg(value) - 1;
    result.decay = 1 - std::pow(std::abs(value), 2 * M_PI / std::arg(value));
  }
  return result;
}

}  // namespace ixos::test
