/// Friction at the quadrature points of a surface, over steps.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "discretization/point_data.hpp"
#include "interaction/friction_step.hpp"
#include "interaction/obstacle.hpp"
#include "term/curved_sides.hpp"
#include "term/interaction.hpp"

namespace ixos {

/// Sides of one element type, the friction law, the obstacle, and what each point stores: the traction that resists
/// slip [E0], and the numbers of FrictionNumber. The elastic slip is that traction over eps; smoothed friction has
/// none.
///
/// A step's slip is (I - n n^T)(u - u_n) with the normal n of the step's start. The potential of a step is therefore a
/// function of the displacement u alone, and its forces are gradients if the threshold is that of the start. Between
/// steps, before begin() and after accept(), the traction is the stored one, whatever the displacement.
template <class SideElement>
class FrictionPoints {
 public:
  using Sides = CurvedSides<SideElement>;
  static constexpr std::size_t D = Sides::D, N = Sides::N;
  using Vector = std::array<Pack, D>;
  using Response = SlipResponse<Pack, D>;
  using Step = FrictionStep<Pack, D>;

  FrictionPoints(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                 const FrictionLaw& law, std::shared_ptr<const Obstacle> obstacle, int points)
      : law_(law),
        obstacle_(std::move(obstacle)),
        sides_(mesh, sides, pattern, points),
        stored_(mesh, sides, sides_.quadrature().size(), D + 3),
        starts_(sides_.size() * sides_.quadrature().size()),
        is_idle_(sides_.size()) {}

  Sides& sides() { return sides_; }
  const Sides& sides() const { return sides_; }
  const FrictionLaw& law() const { return law_; }
  const Obstacle& obstacle() const { return *obstacle_; }

  void clear() {
    stored_.clear();
    in_step_ = false;
    last_work_ = last_lag_ = 0;
  }
  void transfer(Record& record) {
    stored_.transfer(record);
    if (!record.loading()) return;
    in_step_ = false;
    last_work_ = last_lag_ = 0;
  }
  /// Freezes the state of a step's start; a displacement since then will have taken the time `length` [T0].
  void begin(const double* u, double length);
  void set_length(double length) { creep_length_ = law_.friction().slip_speed * length; }
  /// Accepts the step, which ends at u. Returns the sum of the work that it dissipated over the sides of this rank.
  double accept(const double* u);

  /// Returns whether no point of a batch resists slip in this step.
  bool is_idle(std::size_t b) const { return in_step_ && is_idle_[b]; }
  /// Returns the response at a point's displacement. The exact stiffness has the unsymmetric part of a current
  /// threshold, the convex one has it not.
  template <SlipPart part>
  Response respond(std::size_t b, std::size_t q, const Vector& u, SlipKind kind,
                   Tangent tangent = Tangent::Convex) const;
  /// Returns the potential of the step per area. Between steps it is the energy that the elastic slip stores.
  Pack energy(std::size_t b, std::size_t q, const Vector& u) const;
  /// Returns the potential of the mean traction, zero at the step's start.
  Pack mean_potential(std::size_t b, std::size_t q, const Vector& u) const;
  Pack acting_stiffness(std::size_t b, std::size_t q, const Vector& u) const;
  /// Returns a bound of the stiffness in a step that begins at u, with the elastic slip's eps and the part of a current
  /// threshold [E0/L0].
  Pack largest_stiffness(std::size_t b, std::size_t q, const Vector& u) const;
  Pack number(std::size_t b, std::size_t q, FrictionNumber number) const { return stored_(b, q, place_of(number)); }
  /// Adds the report on u.
  void report(const double* u, FrictionReport& report) const;

  /// Returns a nodal array's vector at a quadrature point.
  Vector at(std::size_t q, const typename Sides::Vectors& nodal) const { return first(sides_.interpolate(q, nodal)); }

 private:
  struct Start {
    Vector u, normal;
    Pack threshold;
  };
  struct Contact {
    Pack gap;
    Vector gradient;  ///< of the gap; that of a vertical gap is longer than 1
    Vector normal;    ///< the gradient's direction, or zero
  };

  static std::size_t place_of(FrictionNumber number) { return D + static_cast<std::size_t>(number); }
  static Vector first(const PackPoint& point) {
    Vector result;
    for (std::size_t i = 0; i < D; ++i) result[i] = point[i];
    return result;
  }
  const Start& start(std::size_t b, std::size_t q) const { return starts_[b * sides_.quadrature().size() + q]; }
  Vector stored_traction(std::size_t b, std::size_t q) const {
    Vector t;
    for (std::size_t i = 0; i < D; ++i) t[i] = stored_(b, q, i);
    return t;
  }
  Contact contact_at(const PackPoint& x) const;
  PackPoint place(std::size_t b, std::size_t q, const Vector& u) const;
  Pack threshold(std::size_t b, std::size_t q, const Vector& u) const {
    return law_.friction().current ? law_.threshold(obstacle_->gap(place(b, q, u))) : start(b, q).threshold;
  }
  /// Returns the slip since the step's start.
  Vector slip_since(const Start& start, const Vector& u) const;
  Step step(std::size_t b, std::size_t q, const Vector& u) const {
    return {law_.friction(), creep_length_, stored_traction(b, q), threshold(b, q, u)};
  }
  /// Adds the measure of the point times the slip, times the threshold and its change, to the last two.
  Pack accept(std::size_t b, std::size_t q, const Vector& u, const Contact& end, Pack& work, Pack& lag);

  FrictionLaw law_;
  std::shared_ptr<const Obstacle> obstacle_;
  Sides sides_;
  PointData stored_;  ///< traction, then the numbers of FrictionNumber
  std::vector<Start> starts_;
  std::vector<bool> is_idle_;  ///< by batch, see is_idle()
  double creep_length_ = 0;    ///< length up to which smoothed friction grows, see SmoothedSlip
  bool in_step_ = false;
  double last_work_ = 0, last_lag_ = 0;  ///< of the step that was accepted last, see FrictionReport
};

}  // namespace ixos

#include "term/friction_points_impl.hpp"
