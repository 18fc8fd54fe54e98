/// Friction at the points of a surface before the surface of another body, over steps.
#pragma once
#include <memory>
#include <vector>

#include "discretization/point_data.hpp"
#include "interaction/friction_step.hpp"
#include "term/pair_points.hpp"

namespace ixos {

/// The points of a pair, the friction law, and what each point stores: the traction that resists its slip [E0], and the
/// numbers of FrictionNumber.
///
/// A step's slip is a linear function of the nodes' displacements since its start. With the normal n, the gap g, the
/// weights S of the relative position, and the primary surface's tangents x_k, dual vectors x^k and normal m at the
/// foot, all of the start,
///
///   slip = P (S du - g w x n),   P = I - n n^T,   w = sum of (m/2 c_k^T - c_k m^T) N_,k du,   c_k = m x x^k.
///
/// w is the rotation of the primary surface: a motion of both bodies as one is no slip. The potential of a step is
/// therefore a function of the displacement alone, the forces are its gradient, their sum vanishes, and so does their
/// moment about the places of the start.
///
/// Between steps, before begin() and after accept(), the traction is the stored one, at the feet of the displacement.
/// All ranks have all points.
template <std::size_t D>
class PairSlip {
 public:
  /// A point that friction acts on.
  struct Point {
    typename PairPoints<D>::Contact contact;  ///< with the foot that the slip refers to
    std::vector<int> nodes;                   ///< local, of both surfaces
    std::vector<Small<double, D>> slips;      ///< by node: the derivative of the slip by its displacement
    Small<double, D> plane;                   ///< P
    Vec<D> start{};                           ///< of the linear function, at the displacement of the step's start
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
  /// Returns the linear function of a local array of displacements.
  Vec<D> relative(const Point& point, const double* u) const;
  Vec<D> slip(const Point& point, const double* u) const { return relative(point, u) - point.start; }
  Step step(const Point& point) const { return {friction_.friction(), creep_length_, point.traction, point.threshold}; }
  /// Adds the force that a traction on the primary surface causes at the point's nodes, times the measure, to f.
  void add_force(const Point& point, const Vec<D>& traction, double* f) const;
  /// Adds the matrix of a stiffness d(traction)/d(slip), times the measure, to a block of the point's nodes.
  void add_stiffness(const Point& point, const Small<double, D>& stiffness, std::vector<double>& k) const;

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
  /// Sets everything but the start.
  void set(const typename PairPoints<D>::Contact& contact, Point& point) const;
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
