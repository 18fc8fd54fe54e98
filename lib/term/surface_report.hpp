/// Reports of an interaction on its surface.
#pragma once
#include <array>
#include <limits>
#include <set>
#include <vector>

#include "state/place.hpp"

namespace ixos {

/// This rank's share of an interaction's report on a displacement. Sums over ranks give the whole; for `least_gap`, the
/// minimum.
struct InteractionReport {
  std::vector<double> force;  ///< on the bodies [E0 L0^(D-1)]
  double measure = 0;         ///< reference length or area closer than the gap of largest attraction [L0^(D-1)]
  double least_gap = std::numeric_limits<double>::infinity();  ///< [L0]
};

/// Numbers at the quadrature points of a surface.
enum class SurfaceNumber {
  Pressure,    ///< the law's traction, which is positive where the obstacle pushes the body away [E0]
  Damage,      ///< of the law, in [0, 1]
  Slip,        ///< the length of the slip so far [L0]
  Dissipated,  ///< by friction per reference area, times the interaction's factor [E0 L0]
  Sliding      ///< 1 where friction slid in the last step, else 0
};

/// This rank's share of how surfaces slide along their obstacles. Sums over ranks give the whole. Friction acts where
/// the gap is below its g_cut and its threshold is greater than zero. Measures are reference lengths or areas
/// [L0^(D-1)].
struct FrictionReport {
  double acting = 0;    ///< measure on which friction acts
  double sliding = 0;   ///< measure that slid in the last step
  double sticking = 0;  ///< measure on which friction acts and that did not slide in the last step
  double slip = 0;      ///< integral of the slip so far over the measure on which friction acts [L0^D]
  double work = 0;      ///< integral of the last step's threshold times its slip [E0 L0^D]
  /// Integral of the change of that threshold over the step times the slip; 0 if it is that at the end [E0 L0^D].
  double lag = 0;

  /// Returns the mean of the slip over the measure on which friction acts [L0]; 0 if it acts nowhere.
  double mean_slip() const { return acting > 0 ? slip / acting : 0.0; }
};

/// Sides of cells: local block, cell and side.
using CountedSides = std::set<std::array<int, 3>>;

class SurfaceReport {
 public:
  virtual ~SurfaceReport() = default;

  /// Adds the report on a state.
  virtual void report(const Place& at, InteractionReport& report) const = 0;
  /// Adds the report of friction; nothing if the force is none.
  virtual void report_friction(const Place& at, FrictionReport& report) const = 0;

  /// Returns whether the term has that number. Equal on all ranks.
  virtual bool has(SurfaceNumber number) const = 0;
  /// Adds, per local node, int w_a s dA with that number s; nothing if the term does not have it. The weights are those
  /// of add_nodal_measure(); of Damage, Slip and Sliding without the interaction's factor.
  virtual void add_nodal(SurfaceNumber number, const Place& at, double* sums) const = 0;

  /// Adds, per local node, int w_a dA over those sides of the surface that are not counted yet, and counts them:
  /// several interactions may act on one side. The weight w_a is the shape function N_a [L0^(D-1)], but
  /// N_a/(2 pi R) at a node on the axis of an axisymmetric mesh where int N_a dA vanishes.
  virtual void add_nodal_measure(CountedSides& counted, double* measure) const = 0;

  /// Lowers the numbers by local node to the gaps of the surface's nodes [L0]; NaN stands for no gap yet. At derivative
  /// nodes it is the gap's derivative, if this gap is the least at their corner.
  virtual void lower_nodal_gap(const Place& at, double* gap) const = 0;
  /// Does the same for the surface of the other body, whose gaps are those to this one; nothing if there is none, or if
  /// its nodes have gaps of their own.
  virtual void lower_facing_gap(const Place& /*at*/, double* /*gap*/) const {}

  /// Sets the local array at the surface's nodes to the obstacle's unit normal, away from the obstacle, at its point
  /// nearest to the node. Leaves derivative nodes as they are.
  virtual void set_nodal_normal(const Place& at, double* normal) const = 0;
};

}  // namespace ixos
