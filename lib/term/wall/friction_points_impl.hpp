/// Member functions of FrictionPoints.
#pragma once
#include <cmath>

#include "term/wall/friction_points.hpp"

namespace ixos {

template <std::size_t D>
typename FrictionPoints<D>::Contact FrictionPoints<D>::contact_at(const PackPoint& x) const {
  const ObstacleGap found = obstacle_->gap_and_normal(x);
  Contact contact{found.gap, first(found.normal), {}};
  const Pack square = inner(contact.gradient, contact.gradient);
  const Pack length = std::experimental::sqrt(select(square > 0.0, square, Pack(1.0)));
  for (std::size_t i = 0; i < D; ++i) contact.normal[i] = contact.gradient[i] / length;
  return contact;
}

template <std::size_t D>
PackPoint FrictionPoints<D>::place(std::size_t b, std::size_t q, const Vector& u) const {
  PackPoint x = reference_[index(b, q)];
  for (std::size_t i = 0; i < D; ++i) x[i] += u[i];
  return x;
}

template <std::size_t D>
typename FrictionPoints<D>::Vector FrictionPoints<D>::slip_since(const Start& start, const Vector& u) const {
  Vector slip;
  for (std::size_t i = 0; i < D; ++i) slip[i] = u[i] - start.u[i];
  const Pack along = inner(start.normal, slip);
  for (std::size_t i = 0; i < D; ++i) slip[i] -= along * start.normal[i];
  return slip;
}

template <std::size_t D>
void FrictionPoints<D>::begin(const double* u, double length, const TermHistory& history, Memory& step) const {
  const PointData& kept = history.points.front().values;
  step.starts.resize(sides_->size() * sides_->points());
  step.is_idle.assign(sides_->size(), !law_.friction().current);  // a current threshold may begin within the step
  for_each(u, [&](std::size_t b, std::size_t q, const Vector& here) {
    Start& start = step.starts[index(b, q)];
    start.u = here;
    const Contact contact = contact_at(place(b, q, start.u));
    start.normal = contact.normal;
    start.threshold = law_.threshold(contact.gap);
    const Vector stored = kept_traction(kept, b, q);
    if (!everywhere(start.threshold == 0.0 && inner(stored, stored) == 0.0)) step.is_idle[b] = false;
  });
  set_length(length, step);
}

template <std::size_t D>
template <SlipPart part>
typename FrictionPoints<D>::Response FrictionPoints<D>::In::respond(std::size_t b, std::size_t q, const Vector& u,
                                                                    SlipKind kind, Tangent tangent) const {
  if (step_ == nullptr) return {traction(b, q), {}, {}};
  const Start& start = this->start(b, q);
  Small<Pack, D> plane;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) plane[i][j] = (i == j ? 1.0 : 0.0) - start.normal[i] * start.normal[j];
  Response result = step(b, q, u).template respond<part>(points_.slip_since(start, u), plane, kind);
  const FrictionLaw& law = points_.law_;
  if (part == SlipPart::All && tangent == Tangent::Exact && law.friction().current) {
    const Contact end = points_.contact_at(points_.place(b, q, u));
    const Pack slope = law.slope(end.gap);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) result.stiffness[i][j] += result.by_threshold[i] * (slope * end.gradient[j]);
  }
  return result;
}

template <std::size_t D>
Pack FrictionPoints<D>::In::energy(std::size_t b, std::size_t q, const Vector& u) const {
  if (step_ == nullptr) return Step(points_.law_.friction(), 0.0, traction(b, q), 0.0).stored_energy();
  return step(b, q, u).energy(points_.slip_since(start(b, q), u));
}

template <std::size_t D>
Pack FrictionPoints<D>::In::mean_potential(std::size_t b, std::size_t q, const Vector& u) const {
  return step(b, q, u).mean_potential(points_.slip_since(start(b, q), u));
}

template <std::size_t D>
Pack FrictionPoints<D>::In::acting_stiffness(std::size_t b, std::size_t q, const Vector& u) const {
  if (step_ == nullptr) return 0.0;  // the traction is constant
  return step(b, q, u).acting_stiffness(points_.slip_since(start(b, q), u));
}

template <std::size_t D>
Pack FrictionPoints<D>::largest_stiffness(std::size_t b, std::size_t q, const Vector& u) const {
  const Contact here = contact_at(place(b, q, u));
  const Pack spring = select(law_.threshold(here.gap) > 0.0, Pack(law_.friction().stiffness), Pack(0.0));
  if (!law_.friction().current) return spring;
  // The derivative by the threshold is at most 1.
  return spring +
         std::experimental::abs(law_.slope(here.gap)) * std::experimental::sqrt(inner(here.gradient, here.gradient));
}

/// Updates what the points keep. The traction is carried along with the tangent plane.
template <std::size_t D>
double FrictionPoints<D>::accept(const double* u, double length, const Memory& step, TermHistory& history) const {
  const In points(*this, history, &step, creep_length(length));
  PointData& kept = history.points.front().values;
  Pack sum = 0.0, work = 0.0, lag = 0.0;
  for_each(u, [&](std::size_t b, std::size_t q, const Vector& end_u) {
    const Contact end = contact_at(place(b, q, end_u));
    const Pack begins = points.threshold(b, q, end_u), ends = law_.threshold(end.gap);
    const auto left = points.end(b, q, end_u, ends);
    const Pack weight = sides_->owned(b) * sides_->measure(b)[q], slipped = weight * left.slip;
    work += slipped * begins;
    lag += slipped * (ends - begins);
    sum += weight * left.work;
    const Vector traction = carried(left.traction, points.start(b, q).normal, end.normal);
    for (std::size_t i = 0; i < D; ++i) kept(b, q, i) = traction[i];
    kept(b, q, place_of(SurfaceNumber::Slip)) += left.slip;
    kept(b, q, place_of(SurfaceNumber::Dissipated)) += left.work;
    kept(b, q, place_of(SurfaceNumber::Sliding)) = left.slid;
  });
  history.last_step = {total(work), total(lag)};
  return total(sum);
}

template <std::size_t D>
void FrictionPoints<D>::In::report(const double* u, FrictionReport& report) const {
  const Sides& sides = *points_.sides_;
  const FrictionLaw& law = points_.law_;
  Pack acting = 0.0, sliding = 0.0, sticking = 0.0, slip = 0.0;
  points_.for_each(u, [&](std::size_t b, std::size_t q, const Vector& here) {
    const Pack gap = points_.obstacle_->gap(points_.place(b, q, here));
    const auto near = gap < law.cutoff() && law.threshold(gap) > 0.0;
    // Where the interaction's factor is zero, so is the measure.
    const Pack area = select(sides.measure(b)[q] > 0.0, Pack(sides.owned(b) * sides.area(b)[q]), Pack(0.0));
    const Pack acts = select(near, area, Pack(0.0)), slides = number(b, q, SurfaceNumber::Sliding);
    acting += acts;
    sliding += area * slides;
    sticking += acts * (1.0 - slides);
    slip += acts * number(b, q, SurfaceNumber::Slip);
  });
  report.acting += total(acting);
  report.sliding += total(sliding);
  report.sticking += total(sticking);
  report.slip += total(slip);
  report.work += history_.last_step[0];
  report.lag += history_.last_step[1];
}

}  // namespace ixos
