/// Friction at the points of a surface before the surface of another body, over steps.
#pragma once
#include <memory>
#include <vector>

#include "interaction/friction_law.hpp"
#include "interaction/friction_step.hpp"
#include "state/history.hpp"
#include "state/place.hpp"
#include "term/pair/pair_points.hpp"
#include "term/pair/patch_slip.hpp"

namespace ixos {

/// The points of a pair, and the friction law. A TermHistory keeps at each point the traction that resists its slip
/// [E0], and the numbers of friction.
///
/// The slip of a step is a function of the displacement alone, see PatchSlip, and so is the potential. The sum of the
/// forces vanishes. In the plane their moment about the places of the start vanishes. In space the moment of the forces
/// at a point in time vanishes about the places there.
///
/// accept() carries the traction with the rotation of the primary surface at the closest point. In space that is the
/// rotation in the polar decomposition of the map of the tangents and the normal: neither the parameters of a patch nor
/// the size of the step change it.
///
/// In a state that is not on the way of a step, the traction is the kept one, at the closest points of the
/// displacement. All ranks have all points.
template <std::size_t D>
class PairSlip {
 public:
  using Motion = typename PatchSlip<D>::Motion;
  using Moduli = typename PatchSlip<D>::Moduli;
  /// A point that friction acts on.
  struct Point {
    typename PairPoints<D>::Contact contact;  ///< with the closest point that the slip refers to
    std::vector<int> nodes;                   ///< local, of both surfaces
    PatchSlip<D> map;                         ///< the slip of displacements
    Motion start{};                           ///< at the displacement of the step's start
    Vec<D> traction{};                        ///< at the start
    double threshold = 0;
  };
  using Points = std::vector<Point>;
  using Step = FrictionStep<double, D>;
  /// The start of a step, frozen.
  struct Memory final : StepMemory {
    Points acting;
    double creep_length = 0;  ///< length up to which smoothed friction grows, see SmoothedSlip
  };

  /// The law must be that of the friction's threshold.
  PairSlip(const LocalMesh& mesh, PairSurfaces<D> surfaces, std::shared_ptr<const GapLaw> law,
           const FrictionLaw& friction, const PairOptions& options);

  const FrictionLaw& friction() const { return friction_; }
  const PairPoints<D>& points() const { return points_; }

  /// Returns the history of points that never slid.
  TermHistory history() const;
  /// Freezes the state of a step's start; a displacement since then will have taken the time `length` [T0].
  void begin(const double* u, double length, const TermHistory& history, Memory& step) const;
  void set_length(double length, Memory& step) const { step.creep_length = creep_length(length); }
  /// Accepts a step of that length, which ends at u. Returns the sum of the work that it dissipated over the sides of
  /// this rank. The last two numbers of the history are then FrictionReport::work and lag.
  double accept(const double* u, double length, const Memory& step, TermHistory& history) const;

  /// Returns the points of the step; of a state near(u).
  const Points& acting(const double* u, const TermHistory& history, const Memory* step) const {
    return step != nullptr ? step->acting : near(u, history);
  }
  /// Returns all points whose threshold at u is greater than zero, and those with a kept traction. They are valid until
  /// the next call.
  const Points& near(const double* u, const TermHistory& history) const;
  Motion motion(const Point& point, const double* u) const { return point.map.motion(point.nodes, u); }
  /// Returns the slip of a step to u.
  Vec<D> slip(const Point& point, const double* u) const { return point.map.slip(motion(point, u) - point.start); }
  Step step(const Point& point, double creep_length) const {
    return {friction_.friction(), creep_length, point.traction, point.threshold};
  }
  /// Adds a force of the point's PatchSlip, times the measure, to f.
  void add_force(const Point& point, const Motion& force, double* f) const {
    point.map.add_force(point.nodes, points_.measure(point.contact), force, f);
  }
  /// Adds the matrix of moduli, times the measure, to a block of the point's nodes.
  void add_stiffness(const Point& point, const Moduli& moduli, std::vector<double>& k) const {
    point.map.add_stiffness(points_.measure(point.contact), moduli, k);
  }

  double number(const TermHistory& history, std::size_t patch, std::size_t point, SurfaceNumber number) const {
    return kept(history, patch, point, place_of(number));
  }
  /// Adds the report on u.
  void report(const double* u, const TermHistory& history, FrictionReport& report) const;

 private:
  double creep_length(double length) const { return friction_.friction().slip_speed * length; }
  static std::size_t place_of(SurfaceNumber number) {
    return D + static_cast<std::size_t>(number) - static_cast<std::size_t>(SurfaceNumber::Slip);
  }
  static double kept(const TermHistory& history, std::size_t patch, std::size_t point, std::size_t number);
  static void keep(TermHistory& history, std::size_t patch, std::size_t point, std::size_t number, double value);
  static Vec<D> kept_traction(const TermHistory& history, const typename PairPoints<D>::Contact& contact);
  /// Sets everything but the start. `at`: the contacts that have this one.
  void set(const typename PairPoints<D>::Contacts& at, const typename PairPoints<D>::Contact& contact,
           const TermHistory& history, Point& point) const;
  /// Returns the closest point of a contact. At a kink in space it is that on the first of the patches that meet there,
  /// so that rounding errors do not choose between them.
  SurfaceProjection<D> projection_of(const typename PairPoints<D>::Contacts& at,
                                     const typename PairPoints<D>::Contact& contact) const;
  /// Returns the contacts at u, as far as friction reaches.
  std::shared_ptr<const typename PairPoints<D>::Times> contacts(const double* u) const;

  FrictionLaw friction_;
  double range_;
  PairPoints<D> points_;
  PointData nothing_;    ///< zero traction, then zero numbers
  mutable Points near_;  ///< memory: the last ones that near() returned
};

extern template class PairSlip<2>;
extern template class PairSlip<3>;

}  // namespace ixos
