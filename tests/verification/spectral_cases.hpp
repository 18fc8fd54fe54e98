/// Schemes for the undamped linear oscillator: their amplification matrices and the closed forms of the eigenvalues.
#pragma once
#include <complex>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "support/amplification.hpp"

namespace ixos::test {

using Roots = std::vector<std::complex<double>>;

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// A scheme with parameters, as a scene writes them.
struct Case {
  std::string scheme;
  std::string parameters;
  std::function<Amplification(double)> amplification;  ///< of omega dt
  std::function<Roots(double)> roots;  ///< its eigenvalues in closed form, without those that are always zero
  double at_infinity;                  ///< the spectral radius where omega dt goes to infinity
  double critical = unbounded;         ///< stable for omega dt up to this
};

Case newmark(double beta, double gamma, double at_infinity, double critical = unbounded);
Case bathe(double rho, double split);
Case composite(double beta, double gamma, double at_infinity, double critical = unbounded);
Case trapezoid(const std::string& scheme, const std::string& parameters = "");
Case generalized_alpha(double rho);
Case hht(double alpha);
Case central_difference();

/// At least one of every scheme in the catalogue that moves a body.
const std::vector<Case>& cases();

/// The scheme and the values of its parameters.
std::string name(const Case& one);

}  // namespace ixos::test
