#include "solve/iterative/chebyshev_polynomial.hpp"

#include <Teuchos_LAPACK.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/agreement.hpp"
#include "solve/assemblable_operator.hpp"
#include "solve/iterative/single_products.hpp"

namespace ixos {
namespace {

constexpr std::size_t lanczos_steps = 10;

Vector diagonal_of(const Operator& op) {
  Vector diagonal(op.getRangeMap());
  const auto* assemblable = dynamic_cast<const AssemblableOperator*>(&op);
  if (assemblable != nullptr)
    assemblable->diagonal(diagonal);
  else
    dynamic_cast<const CrsMatrix&>(op).getLocalDiagCopy(diagonal);
  return diagonal;
}

}  // namespace

/// Returns the spectrum of the tridiagonal matrix of Lanczos' method, given also the next entry beside its diagonal;
/// the largest eigenvalue with Zhou and Li's margin (2011).
ChebyshevPolynomial::Spectrum ChebyshevPolynomial::spectrum_of(std::vector<double> diagonal, std::vector<double> beside,
                                                               double next) {
  const auto n = static_cast<int>(diagonal.size());
  std::vector<double> vectors(diagonal.size() * diagonal.size()), work(2 * diagonal.size());
  int info = 0;
  Teuchos::LAPACK<int, double>().STEQR('I', n, diagonal.data(), beside.data(), vectors.data(), n, work.data(), &info);
  if (info != 0) throw std::runtime_error("the spectrum of the tangent cannot be estimated");
  return {diagonal.front(), diagonal.back() + std::abs(vectors.back()) * next};  // in ascending order
}

/// Estimates the spectrum of D^-1/2 W D^-1/2, by Lanczos' method from a vector of the rows' numbers.
ChebyshevPolynomial::Spectrum ChebyshevPolynomial::estimate_spectrum() const {
  const auto map = op_->getDomainMap();
  Vector root(map), v(map), before(map), scaled(map), w(map);
  {
    const auto r = root.getLocalViewHost(Tpetra::Access::OverwriteAll);
    const auto d = inverse_diagonal_->getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto x = v.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < x.extent(0); ++i) {
      r(i, 0) = std::sqrt(d(i, 0));
      x(i, 0) = std::sin(1.0 + 2.4 * static_cast<double>(map->getGlobalElement(static_cast<LocalId>(i))));
    }
  }
  std::vector<double> diagonal, beside;
  v.scale(1 / v.norm2());
  for (double next = 0;;) {
    scaled.elementWiseMultiply(1.0, root, v, 0.0);
    op_->apply(scaled, w);
    scaled.elementWiseMultiply(1.0, root, w, 0.0);
    if (!beside.empty()) scaled.update(-next, before, 1.0);
    diagonal.push_back(scaled.dot(v));
    scaled.update(-diagonal.back(), v, 1.0);
    next = scaled.norm2();
    if (diagonal.size() == lanczos_steps || next <= 1e-12 * std::abs(diagonal[0]))
      return spectrum_of(diagonal, beside, next);
    beside.push_back(next);
    before.assign(v);
    v.update(1 / next, scaled, 0.0);
  }
}

void ChebyshevPolynomial::initialize(const Teuchos::RCP<const Operator>& op, const Settings& settings) {
  op_ = op;
  settings_ = settings;
  if (inverse_diagonal_.is_null()) inverse_diagonal_ = Teuchos::rcp(new Vector(op_->getRangeMap()));
  if (waits_) {
    restore();
  } else {
    invert_diagonal();
    spectrum_ = estimate_spectrum();
  }
  waits_ = false;
}

void ChebyshevPolynomial::transfer(Record& record) {
  std::vector<double> values = loaded_;
  if (nonnull(inverse_diagonal_) && !waits_) {
    const auto view = inverse_diagonal_->getLocalViewHost(Tpetra::Access::ReadOnly);
    values.assign(view.data(), view.data() + view.extent(0));
  }
  record.share("inverse diagonal", values);
  record.number("least eigenvalue", spectrum_.least);
  record.number("largest eigenvalue", spectrum_.largest);
  if (!record.loading()) return;
  if (!std::isfinite(spectrum_.largest) || !(spectrum_.least <= spectrum_.largest) || spectrum_.largest < 0)
    throw InputError("the eigenvalues of a preconditioner are not valid");
  loaded_ = std::move(values);
  waits_ = spectrum_.largest > 0;
}

void ChebyshevPolynomial::restore() {
  together<InputError>(op_->getRangeMap()->getComm(), [&] {
    const auto view = inverse_diagonal_->getLocalViewHost(Tpetra::Access::OverwriteAll);
    if (loaded_.size() != view.extent(0)) throw InputError("a diagonal of the checkpoint has a different size");
    for (double value : loaded_)
      if (!(std::isfinite(value) && value > 0)) throw InputError("a diagonal of the checkpoint is not positive");
    std::copy(loaded_.begin(), loaded_.end(), view.data());
  });
  loaded_.clear();
}

void ChebyshevPolynomial::invert_diagonal() {
  const Vector diagonal = diagonal_of(*op_);
  together<std::runtime_error>(op_->getRangeMap()->getComm(), [&] {
    const auto from = diagonal.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto to = inverse_diagonal_->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < from.extent(0); ++i) {
      const double magnitude = std::abs(from(i, 0));  // attraction may make a row negative; D stays positive
      if (!(magnitude > 0)) throw std::runtime_error("a diagonal entry of the tangent is zero or not a number");
      to(i, 0) = 1 / magnitude;
    }
  });
}

const MultiVector& ChebyshevPolynomial::operator()(const MultiVector& b) const {
  const double largest = settings_.margin * spectrum_.largest;
  const double least = std::clamp(spectrum_.least, largest / settings_.ratio, largest / 1.1);
  const double center = (largest + least) / 2, half_width = (largest - least) / 2;
  if (residual_.is_null() || residual_->getNumVectors() != b.getNumVectors())
    for (auto* scratch : {&residual_, &step_, &sum_})
      *scratch = Teuchos::rcp(new MultiVector(b.getMap(), b.getNumVectors(), false));
  // The iterates start at zero and stay small, so that the errors do, too: a polynomial a little off is as good.
  const SingleProducts single(*op_);
  MultiVector &residual = *residual_, &step = *step_, &sum = *sum_;
  step.elementWiseMultiply(1 / center, *inverse_diagonal_, b, 0.0);
  sum.assign(step);
  double rho = half_width / center;
  for (int i = 1; i < settings_.degree; ++i) {
    residual.assign(b);
    op_->apply(sum, residual, Teuchos::NO_TRANS, -1.0, 1.0);
    const double next = 1 / (2 * center / half_width - rho);
    step.elementWiseMultiply(2 * next / half_width, *inverse_diagonal_, residual, next * rho);
    sum.update(1.0, step, 1.0);
    rho = next;
  }
  return sum;
}

}  // namespace ixos
