/// Member functions of FrictionPoints.
#pragma once
#include <cmath>

#include "term/friction_points.hpp"

namespace ixos {

template <class SideElement>
typename FrictionPoints<SideElement>::Contact FrictionPoints<SideElement>::contact_at(const PackPoint& x) const {
  const Sight sight = obstacle_->gap_and_normal(x);
  Contact contact{sight.gap, first(sight.normal), {}};
  const Pack square = inner(contact.gradient, contact.gradient);
  const Pack length = std::experimental::sqrt(select(square > 0.0, square, Pack(1.0)));
  for (std::size_t i = 0; i < D; ++i) contact.normal[i] = contact.gradient[i] / length;
  return contact;
}

template <class SideElement>
PackPoint FrictionPoints<SideElement>::place(std::size_t b, std::size_t q, const Vector& u) const {
  PackPoint x = sides_.interpolate(q, sides_.reference(b));
  for (std::size_t i = 0; i < D; ++i) x[i] += u[i];
  return x;
}

template <class SideElement>
typename FrictionPoints<SideElement>::Vector FrictionPoints<SideElement>::slip_since(const Start& start,
                                                                                     const Vector& u) const {
  Vector slip;
  for (std::size_t i = 0; i < D; ++i) slip[i] = u[i] - start.u[i];
  const Pack along = inner(start.normal, slip);
  for (std::size_t i = 0; i < D; ++i) slip[i] -= along * start.normal[i];
  return slip;
}

template <class SideElement>
void FrictionPoints<SideElement>::begin(const double* u, double length) {
  for (std::size_t b = 0; b < sides_.size(); ++b) {
    const auto nodal = sides_.change_of(b, u);
    bool idle = !law_.friction().current;  // a current threshold may begin within the step
    for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
      Start& start = starts_[b * sides_.quadrature().size() + q];
      start.u = at(q, nodal);
      const Contact contact = contact_at(place(b, q, start.u));
      start.normal = contact.normal;
      start.threshold = law_.threshold(contact.gap);
      const Vector stored = stored_traction(b, q);
      idle = idle && everywhere(start.threshold == 0.0 && inner(stored, stored) == 0.0);
    }
    is_idle_[b] = idle;
  }
  set_length(length);
  in_step_ = true;
}

template <class SideElement>
template <SlipPart part>
typename FrictionPoints<SideElement>::Response FrictionPoints<SideElement>::respond(std::size_t b, std::size_t q,
                                                                                    const Vector& u, SlipKind kind,
                                                                                    Tangent tangent) const {
  if (!in_step_) return {stored_traction(b, q), {}, {}};
  const Start& start = this->start(b, q);
  Small<Pack, D> plane;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) plane[i][j] = (i == j ? 1.0 : 0.0) - start.normal[i] * start.normal[j];
  Response result = step(b, q, u).template respond<part>(slip_since(start, u), plane, kind);
  if (part == SlipPart::All && tangent == Tangent::Exact && law_.friction().current) {
    const Contact end = contact_at(place(b, q, u));
    const Pack slope = law_.slope(end.gap);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) result.stiffness[i][j] += result.by_threshold[i] * (slope * end.gradient[j]);
  }
  return result;
}

template <class SideElement>
Pack FrictionPoints<SideElement>::energy(std::size_t b, std::size_t q, const Vector& u) const {
  if (!in_step_) return Step(law_.friction(), creep_length_, stored_traction(b, q), 0.0).stored_energy();
  return step(b, q, u).energy(slip_since(start(b, q), u));
}

template <class SideElement>
Pack FrictionPoints<SideElement>::mean_potential(std::size_t b, std::size_t q, const Vector& u) const {
  return step(b, q, u).mean_potential(slip_since(start(b, q), u));
}

template <class SideElement>
Pack FrictionPoints<SideElement>::acting_stiffness(std::size_t b, std::size_t q, const Vector& u) const {
  if (!in_step_) return 0.0;  // the traction is constant
  return step(b, q, u).acting_stiffness(slip_since(start(b, q), u));
}

template <class SideElement>
Pack FrictionPoints<SideElement>::largest_stiffness(std::size_t b, std::size_t q, const Vector& u) const {
  const Contact here = contact_at(place(b, q, u));
  const Pack spring = select(law_.threshold(here.gap) > 0.0, Pack(law_.friction().stiffness), Pack(0.0));
  if (!law_.friction().current) return spring;
  // The derivative by the threshold is at most 1.
  return spring +
         std::experimental::abs(law_.slope(here.gap)) * std::experimental::sqrt(inner(here.gradient, here.gradient));
}

template <class SideElement>
double FrictionPoints<SideElement>::accept(const double* u) {
  Pack sum = 0.0, work = 0.0, lag = 0.0;
  for (std::size_t b = 0; b < sides_.size(); ++b) {
    const auto nodal = sides_.change_of(b, u);
    for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
      const Vector end = at(q, nodal);
      sum += sides_.owned(b) * sides_.measure(b)[q] * accept(b, q, end, contact_at(place(b, q, end)), work, lag);
    }
  }
  in_step_ = false;
  last_work_ = total(work);
  last_lag_ = total(lag);
  return total(sum);
}

/// Updates what a point stores. Returns the work dissipated per area. The traction is carried along with the tangent
/// plane.
template <class SideElement>
Pack FrictionPoints<SideElement>::accept(std::size_t b, std::size_t q, const Vector& u, const Contact& end, Pack& work,
                                         Pack& lag) {
  const Start& start = this->start(b, q);
  const Pack begins = threshold(b, q, u), ends = law_.threshold(end.gap);
  const auto left = step(b, q, u).end(slip_since(start, u), ends);
  const Pack slipped = sides_.owned(b) * sides_.measure(b)[q] * left.slip;
  work += slipped * begins;
  lag += slipped * (ends - begins);
  const Vector traction = carried(left.traction, start.normal, end.normal);
  for (std::size_t i = 0; i < D; ++i) stored_(b, q, i) = traction[i];
  stored_(b, q, place_of(FrictionNumber::Slip)) += left.slip;
  stored_(b, q, place_of(FrictionNumber::Dissipated)) += left.work;
  stored_(b, q, place_of(FrictionNumber::Sliding)) = left.slid;
  return left.work;
}

template <class SideElement>
void FrictionPoints<SideElement>::report(const double* u, FrictionReport& report) const {
  Pack acting = 0.0, sliding = 0.0, sticking = 0.0, slip = 0.0;
  for (std::size_t b = 0; b < sides_.size(); ++b) {
    const auto nodal = sides_.change_of(b, u);
    for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
      const Pack gap = obstacle_->gap(place(b, q, at(q, nodal)));
      const auto near = gap < law_.cutoff() && law_.threshold(gap) > 0.0;
      // Where the interaction's factor is zero, so is the measure.
      const Pack area = select(sides_.measure(b)[q] > 0.0, Pack(sides_.owned(b) * sides_.area(b)[q]), Pack(0.0));
      const Pack acts = select(near, area, Pack(0.0)), slides = number(b, q, FrictionNumber::Sliding);
      acting += acts;
      sliding += area * slides;
      sticking += acts * (1.0 - slides);
      slip += acts * number(b, q, FrictionNumber::Slip);
    }
  }
  report.acting += total(acting);
  report.sliding += total(sliding);
  report.sticking += total(sticking);
  report.slip += total(slip);
  report.work += last_work_;
  report.lag += last_lag_;
}

}  // namespace ixos
