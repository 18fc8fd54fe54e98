/// The quadrature points of a surface before the surface of another body.
#pragma once
#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "discretization/pattern.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/pair_gap.hpp"
#include "term/interaction.hpp"
#include "term/side_curves.hpp"

namespace ixos {

struct PairOptions {
  int points = 0;          ///< Gauss points on each side of the secondary surface; 0: 5
  double margin = 0.8;     ///< kappa: a Newton step keeps g_new >= kappa min(g, equilibrium gap)
  SurfaceFactor factor{};  ///< of the law's energy, on the secondary surface
};

/// The secondary surface (slave), on which the law is integrated, Pi = sum of w psi(g), and the primary one (master),
/// from which its gaps g are measured: signed least distances. All ranks have all sides of both. A rank looks at the
/// points that add to forces at its own nodes: all of them if it owns nodes of the primary surface, otherwise those of
/// segments with own nodes.
class PairPoints {
 public:
  PairPoints(const LocalMesh& mesh, SideCurves secondary, SideCurves primary, std::shared_ptr<const GapLaw> law,
             const PairOptions& options);

  /// The points that a function visits: those that add to this rank's forces, or those that energies count here.
  enum class Share { Forces, Energies };
  /// Both surfaces at one place.
  struct Places {
    std::vector<Planar> secondary, primary;
    bool is_finite() const;
  };
  /// A quadrature point at one place of the surfaces. Without a foot the law does not act.
  struct Contact {
    std::size_t segment, point;
    Planar place{};
    SurfaceFoot foot;
    double traction = 0, stiffness = 0;  ///< T and -dT/dg
  };
  struct Contacts {
    Places places;
    std::vector<Contact> all;
    double least_gap = std::numeric_limits<double>::infinity();
  };
  /// The matrix of the points of one secondary segment whose feet are on one primary segment.
  struct Block {
    int primary;
    std::size_t count = 0;
    std::array<int, PairGap::most> nodes{};  ///< local
    PairGap::Matrix k{};
  };

  Places places(const double* u) const;
  Places places(const Segment& segment, const RulePoint& point) const;
  /// Returns ways as places: a displacement without the undeformed body's coordinates.
  Places ways(const double* direction) const;
  /// Returns the points, their gaps and what the law says. Coordinates that are no numbers give numbers that are none.
  Contacts contacts(Places places, Share share) const;
  /// Returns the point's gap with its derivatives; the contact must have a foot.
  PairGap gap_of(const Contacts& contacts, const Contact& contact) const;
  /// Returns the local nodes of a contact, in the order of PairGap.
  std::array<int, PairGap::most> nodes_of(const Contact& contact) const;
  /// Calls visit(block) for each matrix of the rule's tangent.
  template <class Visit>
  void for_each_block(const Segment& segment, const Rule& rule, Tangent kind, const Visit& visit) const;

  /// Returns quadrature weight times reference length, with and without the factor [L0^(D-1)].
  double measure(const Contact& c) const { return points_[index(c)].measure; }
  double area(const Contact& c) const { return points_[index(c)].area; }
  const CurveSegment::Weights& weights(const Contact& c) const { return points_[index(c)].weights; }
  bool counts(std::size_t segment) const { return secondary_.owned[segment] != 0; }
  const SideCurves& secondary() const { return secondary_; }
  const SideCurves& primary() const { return primary_; }
  const GapLaw& law() const { return *law_; }
  bool is_positive() const { return law_->domain() == GapDomain::Positive; }
  std::size_t points_of_a_segment() const { return per_segment_; }
  std::size_t index(const Contact& c) const { return c.segment * per_segment_ + c.point; }

 private:
  struct Point {
    CurveSegment::Weights weights;
    double measure, area;
  };
  Places combine(double rest, const std::array<std::pair<double, const double*>, 3>& parts) const;
  void evaluate_law(Contacts& contacts) const;
  void add(const Contacts& contacts, const Contact& contact, double factor, Tangent kind,
           std::vector<Block>& blocks) const;

  std::vector<double> coordinates_;  ///< of the local mesh
  SideCurves secondary_, primary_;
  std::shared_ptr<const GapLaw> law_;
  double range_;
  std::size_t per_segment_;
  std::vector<Point> points_;
  std::vector<char> adds_to_own_;  ///< by segment
};

template <class Visit>
void PairPoints::for_each_block(const Segment& segment, const Rule& rule, Tangent kind, const Visit& visit) const {
  std::vector<Contacts> times;
  std::vector<double> factors;
  for (const RulePoint& point : rule.points) {
    if (point.weight * point.to == 0) continue;
    times.push_back(contacts(places(segment, point), Share::Forces));
    factors.push_back(point.weight * point.to);
  }
  if (times.empty()) return;
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < times.front().all.size(); ++i) {
    for (std::size_t k = 0; k < times.size(); ++k) add(times[k], times[k].all[i], factors[k], kind, blocks);
    const bool last =
        i + 1 == times.front().all.size() || times.front().all[i + 1].segment != times.front().all[i].segment;
    if (!last) continue;
    for (const Block& block : blocks) visit(block);
    blocks.clear();
  }
}

}  // namespace ixos
