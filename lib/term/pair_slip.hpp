/// Friction at the points of a surface before the surface of another body, over steps.
#pragma once
#include <memory>
#include <vector>

#include "discretization/point_data.hpp"
#include "interaction/friction_step.hpp"
#include "term/pair_points.hpp"
#include "term/patch_slip.hpp"

namespace ixos {

/// The points of a pair, the friction law, and what each point stores: the traction that resists its slip [E0], and the
/// numbers of FrictionNumber.
///
/// The slip of a step is a function of the displacement alone, see PatchSlip, and so is the potential. The sum of the
/// forces vanishes. In the plane their moment about the places of the start vanishes. In space the moment of the forces
/// at a point in time vanishes about the places there.
///
/// accept() carries the traction with the rotation of the primary surface at the foot. In space that is the rotation in
/// the polar decomposition of the map of the tangents and the normal: neither the parameters of a patch nor the size of
/// the step change it.
///
/// Between steps, before begin() and after accept(), the traction is the stored one, at the feet of the displacement.
/// All ranks have all points.
template <std::size_t D>
class PairSlip {
 public:
  using Motion = typename PatchSlip<D>::Motion;
  using Moduli = typename PatchSlip<D>::Moduli;
  /// A point that friction acts on.
  struct Point {
    typename PairPoints<D>::Contact contact;  ///< with the foot that the slip refers to
    std::vector<int> nodes;                   ///< local, of both surfaces
    PatchSlip<D> map;                         ///< the slip of displacements
    Motion start{};                           ///< at the displacement of the step's start
    Vec<D> traction{};                        ///< at the start
    double threshold = 0;
  };
  using Points = std::vector<Point>;
  using Step = FrictionStep<double, D>;

  /// `sides`: those of the secondary surface, in its order. The law must be that of the friction's threshold.
  PairSlip(const LocalMesh& mesh, PairSurfaces<D> surfaces, const std::vector<LocalSide>& sides,
           std::shared_ptr<const GapLaw> law, const FrictionLaw& friction, const PairOptions& options);

  const FrictionLaw& friction() const { return friction_; }
  const PairPoints<D>& points() const { return points_; }

  void clear();
  void transfer(Record& record);
  /// Freezes the state of a step's start; a displacement since then will have taken the time `length` [T0].
  void begin(const double* u, double length);
  void set_length(double length) { creep_length_ = friction_.friction().slip_speed * length; }
  /// Accepts the step, which ends at u. Returns the sum of the work that it dissipated over the sides of this rank.
  double accept(const double* u);

  bool in_step() const { return in_step_; }
  /// Returns the points of the step; between steps near(u).
  const Points& acting(const double* u) const { return in_step_ ? acting_ : near(u); }
  /// Returns all points whose threshold at u is greater than zero, and those with a stored traction. They are valid
  /// until the next call.
  const Points& near(const double* u) const;
  Motion motion(const Point& point, const double* u) const { return point.map.motion(point.nodes, u); }
  /// Returns the change since the step's start; zero between steps.
  Motion change(const Point& point, const Motion& here) const { return in_step_ ? here - point.start : Motion{}; }
  Vec<D> slip(const Point& point, const double* u) const { return point.map.slip(change(point, motion(point, u))); }
  Step step(const Point& point) const { return {friction_.friction(), creep_length_, point.traction, point.threshold}; }
  /// Adds a force of the point's PatchSlip, times the measure, to f.
  void add_force(const Point& point, const Motion& force, double* f) const {
    point.map.add_force(point.nodes, points_.measure(point.contact), force, f);
  }
  /// Adds the matrix of moduli, times the measure, to a block of the point's nodes.
  void add_stiffness(const Point& point, const Moduli& moduli, std::vector<double>& k) const {
    point.map.add_stiffness(points_.measure(point.contact), moduli, k);
  }

  double number(std::size_t patch, std::size_t point, FrictionNumber number) const {
    return stored(patch, point, place_of(number));
  }
  /// Adds the report on u.
  void report(const double* u, FrictionReport& report) const;

 private:
  static std::size_t place_of(FrictionNumber number) { return D + static_cast<std::size_t>(number); }
  double stored(std::size_t patch, std::size_t point, std::size_t number) const;
  void store(std::size_t patch, std::size_t point, std::size_t number, double value);
  Vec<D> stored_traction(const typename PairPoints<D>::Contact& contact) const;
  /// Sets everything but the start. `at`: the contacts that have this one.
  void set(const typename PairPoints<D>::Contacts& at, const typename PairPoints<D>::Contact& contact,
           Point& point) const;
  /// Returns the foot of a contact. At a kink in space it is that on the first of the patches that meet there, so that
  /// rounding errors do not choose between them.
  SurfaceFoot<D> foot_of(const typename PairPoints<D>::Contacts& at,
                         const typename PairPoints<D>::Contact& contact) const;
  /// Returns the contacts at u, as far as friction reaches.
  std::shared_ptr<const typename PairPoints<D>::Times> contacts(const double* u) const;

  FrictionLaw friction_;
  double range_;
  PairPoints<D> points_;
  PointData stored_;     ///< traction, then the numbers of FrictionNumber
  Points acting_;        ///< of the step
  mutable Points near_;  ///< the last ones that near() returned; both keep their memory
  double creep_length_ = 0;
  bool in_step_ = false;
  double last_work_ = 0, last_lag_ = 0;  ///< of the step that was accepted last, see FrictionReport
};

extern template class PairSlip<2>;
extern template class PairSlip<3>;

}  // namespace ixos
