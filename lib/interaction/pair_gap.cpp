#include "interaction/pair_gap.hpp"

namespace ixos {

PairGap::PairGap(const CurveSegment::Weights& weights, std::size_t count, const CurveSegment& segment,
                 const CurveSegment::Points& x, const SurfaceFoot& foot)
    : nodes_(count + segment.count), normal_(foot.normal), gap_(foot.gap), round_(foot.end >= 0) {
  const CurveSegment::Weights n = segment.weights(foot.t), slope = segment.slopes(foot.t);
  for (std::size_t a = 0; a < count; ++a) s_[a] = weights[a];
  for (std::size_t a = 0; a < segment.count; ++a) {
    s_[count + a] = -n[a];
    d_[count + a] = slope[a];
  }
  if (round_) return;
  tangent_ = segment.sum(slope, x);
  metric_ = dot(tangent_, tangent_);
  bend_ = dot(segment.sum(segment.curvatures(foot.t), x), normal_);
  divisor_ = metric_ - gap_ * bend_;
}

PairGap::Vector PairGap::gradient() const {
  Vector result{};
  for (std::size_t a = 0; a < nodes_; ++a)
    for (std::size_t i = 0; i < 2; ++i) result[2 * a + i] = s_[a] * normal_[i];
  return result;
}

void PairGap::add(double along, double across, Matrix& matrix) const {
  const std::size_t size = 2 * nodes_;
  const Vector grad = gradient();
  for (std::size_t r = 0; r < size; ++r)
    for (std::size_t c = 0; c < size; ++c) matrix[r][c] += along * grad[r] * grad[c];
  if (round_) {
    const Planar t{-normal_[1], normal_[0]};
    for (std::size_t r = 0; r < size; ++r)
      for (std::size_t c = 0; c < size; ++c)
        matrix[r][c] += across / gap_ * (s_[r / 2] * t[r % 2]) * (s_[c / 2] * t[c % 2]);
    return;
  }
  Vector p{}, c{};
  for (std::size_t r = 0; r < size; ++r) {
    const double turn = d_[r / 2] * normal_[r % 2];
    p[r] = (s_[r / 2] * tangent_[r % 2] + gap_ * turn) / divisor_;
    c[r] = turn + bend_ * p[r];
  }
  for (std::size_t r = 0; r < size; ++r)
    for (std::size_t k = 0; k < size; ++k)
      matrix[r][k] += across * (bend_ * p[r] * p[k] - c[r] * p[k] - p[r] * c[k] + gap_ / metric_ * c[r] * c[k]);
}

}  // namespace ixos
