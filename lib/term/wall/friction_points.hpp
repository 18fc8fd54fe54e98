/// Friction at the quadrature points of a surface, over steps.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "base/scratch.hpp"
#include "interaction/friction_law.hpp"
#include "interaction/friction_step.hpp"
#include "interaction/obstacle.hpp"
#include "state/history.hpp"
#include "state/place.hpp"
#include "term/interaction.hpp"
#include "term/slip_history.hpp"
#include "term/wall/wall_sides.hpp"

namespace ixos {

/// Sides in D dimensions, the friction law, and the obstacle. A TermHistory keeps at each point the traction that
/// resists slip [E0], and the numbers of friction. The elastic slip is that traction over eps; smoothed friction has
/// none.
///
/// A step's slip is (I - n n^T)(u - u_n) with the normal n of the step's start. The potential of a step is therefore a
/// function of the displacement u alone, and its forces are gradients if the threshold is that of the start. In a state
/// that is not on the way of a step, the traction is the kept one, whatever the displacement.
template <std::size_t D>
class FrictionPoints {
 public:
  using Sides = CurvedWallSides<D>;
  using Vector = std::array<Pack, D>;
  using Response = SlipResponse<Pack, D>;
  using Step = FrictionStep<Pack, D>;

  struct Start {
    Vector u, normal;
    Pack threshold;
  };
  /// The start of a step, frozen.
  struct Memory final : StepMemory {
    std::vector<Start> starts;  ///< batches x quadrature points
    std::vector<bool> is_idle;  ///< by batch: no point resists slip in this step
    double creep_length = 0;    ///< length up to which smoothed friction grows, see SmoothedSlip
  };

  FrictionPoints(const LocalMesh& mesh, const std::vector<LocalSide>& group, std::unique_ptr<Sides> sides,
                 const FrictionLaw& law, std::shared_ptr<const Obstacle> obstacle)
      : law_(law),
        obstacle_(std::move(obstacle)),
        sides_(std::move(sides)),
        nothing_(mesh, group, sides_->points(), D + 3),
        reference_(sides_->size() * sides_->points()) {
    for (std::size_t b = 0; b < sides_->size(); ++b)
      sides_->changes(b, mesh.coordinates.data(), &reference_[index(b, 0)]);
  }

  Sides& sides() const { return *sides_; }
  const FrictionLaw& law() const { return law_; }
  const Obstacle& obstacle() const { return *obstacle_; }

  /// Returns the history of points that never slid.
  TermHistory history() const { return slip_history(D, nothing_, sides_->reference_places()); }
  /// Freezes the state of a step's start; a displacement since then will have taken the time `length` [T0].
  void begin(const double* u, double length, const TermHistory& history, Memory& step) const;
  /// Sets the time that a displacement will have taken, for a stage.
  void set_length(double length, Memory& step) const { step.creep_length = creep_length(length); }
  /// Accepts a step of that length, which ends at u. Returns the sum of the work that it dissipated over the sides of
  /// this rank. The last two numbers of the history are then FrictionReport::work and lag.
  double accept(const double* u, double length, const Memory& step, TermHistory& history) const;

  /// The points with what they keep: in a state, or on the way of a step.
  class In {
   public:
    /// `step`: null in a state.
    In(const FrictionPoints& points, const TermHistory& history, const Memory* step)
        : In(points, history, step, step != nullptr ? step->creep_length : 0) {}
    In(const FrictionPoints& points, const TermHistory& history, const Memory* step, double creep_length)
        : points_(points),
          kept_(history.points.front().values),
          history_(history),
          step_(step),
          creep_length_(creep_length) {}

    /// Returns whether no point of a batch resists slip in this step.
    bool is_idle(std::size_t b) const { return step_ != nullptr && step_->is_idle[b]; }
    /// Returns the response at a point's displacement. The exact stiffness has the unsymmetric part of a current
    /// threshold, the convex one has it not.
    template <SlipPart part>
    Response respond(std::size_t b, std::size_t q, const Vector& u, SlipKind kind,
                     Tangent tangent = Tangent::Convex) const;
    /// Returns the potential of the step per area. In a state it is the energy that the elastic slip stores.
    Pack energy(std::size_t b, std::size_t q, const Vector& u) const;
    /// Returns the potential of the mean traction, zero at the step's start.
    Pack mean_potential(std::size_t b, std::size_t q, const Vector& u) const;
    Pack acting_stiffness(std::size_t b, std::size_t q, const Vector& u) const;
    Pack number(std::size_t b, std::size_t q, SurfaceNumber number) const { return kept_(b, q, place_of(number)); }
    /// Adds the report on u.
    void report(const double* u, FrictionReport& report) const;
    /// Returns what a step to u leaves behind at a point.
    typename Step::End end(std::size_t b, std::size_t q, const Vector& u, const Pack& threshold) const {
      return step(b, q, u).end(points_.slip_since(start(b, q), u), threshold);
    }
    const Start& start(std::size_t b, std::size_t q) const { return step_->starts[points_.index(b, q)]; }
    Pack threshold(std::size_t b, std::size_t q, const Vector& u) const {
      return points_.law_.friction().current ? points_.threshold_at(b, q, u) : start(b, q).threshold;
    }

   private:
    Vector traction(std::size_t b, std::size_t q) const { return kept_traction(kept_, b, q); }
    Step step(std::size_t b, std::size_t q, const Vector& u) const {
      return {points_.law_.friction(), creep_length_, traction(b, q), threshold(b, q, u)};
    }

    const FrictionPoints& points_;
    const PointData& kept_;
    const TermHistory& history_;
    const Memory* step_;
    double creep_length_;
  };

  /// Returns a bound of the stiffness in a step that begins at u, with the elastic slip's eps and the part of a current
  /// threshold [E0/L0].
  Pack largest_stiffness(std::size_t b, std::size_t q, const Vector& u) const;

  /// Returns the components that a vector has in D dimensions.
  static Vector first(const PackPoint& point) {
    Vector result;
    for (std::size_t i = 0; i < D; ++i) result[i] = point[i];
    return result;
  }

  /// Calls visit(batch, quadrature point, displacement).
  template <class Visit>
  void for_each(const double* u, const Visit& visit) const {
    Scratch<PackPoint> at(sides_->points());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      sides_->changes(b, u, at.data());
      for (std::size_t q = 0; q < at.size(); ++q) visit(b, q, first(at[q]));
    }
  }

 private:
  double creep_length(double length) const { return law_.friction().slip_speed * length; }

  struct Contact {
    Pack gap;
    Vector gradient;  ///< of the gap; that of a vertical gap is longer than 1
    Vector normal;    ///< the gradient's direction, or zero
  };

  static std::size_t place_of(SurfaceNumber number) {
    return D + static_cast<std::size_t>(number) - static_cast<std::size_t>(SurfaceNumber::Slip);
  }
  static Vector kept_traction(const PointData& kept, std::size_t b, std::size_t q) {
    Vector t;
    for (std::size_t i = 0; i < D; ++i) t[i] = kept(b, q, i);
    return t;
  }
  std::size_t index(std::size_t b, std::size_t q) const { return b * sides_->points() + q; }
  Contact contact_at(const PackPoint& x) const;
  PackPoint place(std::size_t b, std::size_t q, const Vector& u) const;
  Pack threshold_at(std::size_t b, std::size_t q, const Vector& u) const {
    return law_.threshold(obstacle_->gap(place(b, q, u)));
  }
  /// Returns the slip since the step's start.
  Vector slip_since(const Start& start, const Vector& u) const;

  FrictionLaw law_;
  std::shared_ptr<const Obstacle> obstacle_;
  std::unique_ptr<Sides> sides_;
  PointData nothing_;                 ///< zero traction, then zero numbers
  std::vector<PackPoint> reference_;  ///< places of the points without displacement
};

}  // namespace ixos

#include "term/wall/friction_points_impl.hpp"
