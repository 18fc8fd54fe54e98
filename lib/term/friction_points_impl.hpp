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
typename FrictionPoints<SideElement>::Vector FrictionPoints<SideElement>::potential_slip(std::size_t b, std::size_t q,
                                                                                         const Vector& u) const {
  Vector slip = elastic_slip(b, q);
  const Vector since = slip_since(start(b, q), u);
  for (std::size_t i = 0; i < D; ++i) slip[i] += since[i];
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
                                                                                    const Vector& u, Kind kind,
                                                                                    Tangent tangent) const {
  if (!in_step_) return {stored_traction(b, q), {}, {}};
  const Start& start = this->start(b, q);
  Small<Pack, D> plane;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) plane[i][j] = (i == j ? 1.0 : 0.0) - start.normal[i] * start.normal[j];
  const Pack threshold = this->threshold(b, q, u);
  Response result;
  if (is_smoothed()) {
    const SmoothedSlip<Pack, D> potential(creep_length_, threshold);
    const Vector slip = slip_since(start, u);
    result = kind == Kind::Mean ? potential.mean(slip, plane) : potential.at(slip, plane);
  } else {
    const ElasticSlip<Pack, D> potential(law_.friction().stiffness, threshold);
    result = kind == Kind::Mean ? potential.template mean<part>(elastic_slip(b, q), slip_since(start, u), plane)
                                : potential.at(potential_slip(b, q, u), plane);
  }
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
  const double stiffness = law_.friction().stiffness;
  if (!in_step_) {
    const Vector slip = elastic_slip(b, q);
    return 0.5 * stiffness * inner(slip, slip);
  }
  const Vector slip = potential_slip(b, q, u);
  const Pack threshold = this->threshold(b, q, u);
  return is_smoothed() ? SmoothedSlip<Pack, D>(creep_length_, threshold).energy(slip)
                       : ElasticSlip<Pack, D>(stiffness, threshold).energy(slip);
}

template <class SideElement>
Pack FrictionPoints<SideElement>::mean_potential(std::size_t b, std::size_t q, const Vector& u) const {
  const Vector since = slip_since(start(b, q), u);
  const Pack threshold = this->threshold(b, q, u);
  if (is_smoothed()) return SmoothedSlip<Pack, D>(creep_length_, threshold).mean_potential(since);
  return ElasticSlip<Pack, D>(law_.friction().stiffness, threshold).mean_potential(elastic_slip(b, q), since);
}

template <class SideElement>
Pack FrictionPoints<SideElement>::acting_stiffness(std::size_t b, std::size_t q, const Vector& u) const {
  if (!in_step_) return 0.0;  // the traction is constant
  const Vector slip = potential_slip(b, q, u);
  const Pack threshold = this->threshold(b, q, u), length = std::experimental::sqrt(inner(slip, slip));
  // Smoothed friction is stiffest at no slip: 2 T_s/d.
  const Pack radius = is_smoothed() ? Pack(0.5 * creep_length_) : Pack(threshold / law_.friction().stiffness);
  const auto acts = threshold > 0.0;
  return select(acts, Pack(threshold / select(acts, std::experimental::max(length, radius), Pack(1.0))), Pack(0.0));
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
  Pack sum = 0.0;
  for (std::size_t b = 0; b < sides_.size(); ++b) {
    const auto nodal = sides_.change_of(b, u);
    for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
      const Vector end = at(q, nodal);
      sum += sides_.owned(b) * sides_.measure(b)[q] * accept(b, q, end, contact_at(place(b, q, end)));
    }
  }
  in_step_ = false;
  return total(sum);
}

/// Updates what a point stores. Returns the work dissipated per area, the parts of docs/theory.md, "Friction", in their
/// order. The traction is then carried along with the tangent plane by the smallest rotation.
template <class SideElement>
Pack FrictionPoints<SideElement>::accept(std::size_t b, std::size_t q, const Vector& u, const Contact& end) {
  const Start& start = this->start(b, q);
  const Vector slip = potential_slip(b, q, u);
  const Pack threshold = this->threshold(b, q, u), end_threshold = law_.threshold(end.gap);
  const double stiffness = law_.friction().stiffness;
  const auto positive = [](const Pack& x) { return select(x > 0.0, x, Pack(0.0)); };
  const auto length = [](const Vector& x) { return Pack(std::experimental::sqrt(inner(x, x))); };
  Pack work, plastic_slip;
  Pack least = creep_length_;  // smoothed friction slides fully beyond its creep
  Vector traction;
  if (is_smoothed()) {
    const SmoothedSlip<Pack, D> potential(creep_length_, threshold);
    work = potential.energy(slip);
    plastic_slip = length(slip);
    traction = potential.at(slip, {}).traction;
  } else {
    const ElasticSlip<Pack, D> potential(stiffness, threshold);
    const Pack radius = threshold / stiffness, excess = positive(length(elastic_slip(b, q)) - radius);
    plastic_slip = positive(length(slip) - radius);
    work = threshold * plastic_slip + 0.5 * stiffness * excess * excess;
    traction = potential.at(slip, {}).traction;
    least = 1e-10 * radius;  // a surface that comes to rest slides by rounding
  }
  plastic_slip = select(threshold > 0.0, plastic_slip, Pack(0.0));  // a surface that is apart does not slide
  const Pack size = length(traction), drop = positive(size - end_threshold);
  const Pack share = select(drop > 0.0, Pack(end_threshold / select(size > 0.0, size, Pack(1.0))), Pack(1.0));
  if (!is_smoothed()) {
    plastic_slip += drop / stiffness;
    work += 0.5 * (size + end_threshold) * (drop / stiffness);
  }
  for (Pack& component : traction) component *= share;
  const Pack turn = inner(end.normal, traction) / (1.0 + inner(start.normal, end.normal));
  for (std::size_t i = 0; i < D; ++i) stored_(b, q, i) = traction[i] - turn * (start.normal[i] + end.normal[i]);
  stored_(b, q, place_of(FrictionNumber::Slip)) += plastic_slip;
  stored_(b, q, place_of(FrictionNumber::Dissipated)) += work;
  stored_(b, q, place_of(FrictionNumber::Sliding)) = select(plastic_slip > least, Pack(1.0), Pack(0.0));
  return work;
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
}

}  // namespace ixos
