/// The quadrature points of a surface before the surface of another body.
#pragma once
#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/pair_gap.hpp"
#include "interaction/gap_law.hpp"
#include "term/interaction.hpp"
#include "term/pair/pair_block.hpp"
#include "term/pair/pair_contacts.hpp"
#include "term/pair/pair_sums.hpp"
#include "term/pair/self_visibility.hpp"

namespace ixos {

struct PairOptions {
  int points = 0;          ///< Gauss points per direction on each side of the secondary surface; 0: 5
  double margin = 0.8;     ///< kappa: a Newton step keeps g_new >= kappa min(g, equilibrium gap)
  SurfaceFactor factor{};  ///< of the law's energy, on the secondary surface
  /// Greater than 0: both surfaces are one, which interacts with itself. Parts nearer than this along the surface do
  /// not interact [L0]; the law must have a range. Each pair of places counts twice, so that the energy is halved.
  double exclusion = 0;
  double share = 1;    ///< of the law's energy, in (0, 1]: that of one of two passes
  bool reacts = true;  ///< whether the primary surface takes the reaction; if not, the force is no gradient
  /// Depth of the deepest overlap on which a law acts that is defined at every gap, if that exceeds its range: see
  /// overlap_depth() [L0].
  double depth = 0;
};

/// Returns the depth below the primary surface down to which a place can be in its body: infinity if the surface is
/// closed, because its gaps then tell inside from outside. Otherwise it is the greatest depth of a node of the blocks
/// that have its sides, at rest: a place that is deeper is behind the body. This rank's share; the maximum over ranks
/// gives the whole.
template <std::size_t D>
double overlap_depth(const LocalMesh& mesh, const SurfacePatches<D>& primary);

/// The secondary surface (slave), on which the law is integrated, Pi = sum of w psi(g), and the primary one (master),
/// from which its gaps g are measured: signed least distances. All ranks have all sides of both. A rank looks at the
/// points that add to forces at its own nodes: those of patches with own nodes, and others whose closest points can lie
/// on primary patches with own nodes.
template <std::size_t D>
class PairPoints {
 public:
  PairPoints(const LocalMesh& mesh, PairSurfaces<D> surfaces, std::shared_ptr<const GapLaw> law,
             const PairOptions& options);

  PairPoints(const PairPoints&) = delete;
  PairPoints& operator=(const PairPoints&) = delete;

  /// The points that a function visits: those that add to this rank's forces, those that energies count here, or all.
  enum class Share { Forces, Energies, All };
  using Places = PairPlaces<D>;
  using Contact = PairContact<D>;
  using Contacts = PairContacts<D>;
  using Times = PairTimes<D>;

  /// Forgets all closest points, so that those of a step depend on it alone. From then on the closest points at one
  /// place are searched from those at the last ones.
  void begin_step() const {
    last_ = nullptr;
    remembers_ = true;
    search_.begin_step();
  }
  /// Forgets them before the first step of a motion.
  void begin_anew() const {
    last_ = nullptr;
    remembers_ = false;
    search_.begin_step();
  }
  Places places(const double* u) const;
  void place(const double* u, Places& at) const;
  void place(const Segment& segment, const RulePoint& point, Places& at) const;
  /// Sets places to ways: a displacement without the undeformed body's coordinates.
  void place_ways(const double* direction, Places& ways) const;
  /// Returns the places at the points of a rule and, after them, those at the end of the step if the law needs positive
  /// gaps there and the rule has no point there. They are valid until the next call.
  const std::vector<Places>& places(const Segment& segment, const Rule& rule) const;
  /// Returns the points that have neighbours at one of these places or at those of `also`, their gaps and what the law
  /// says. If a coordinate is NaN, all gaps and tractions are NaN. `range`: of gaps; negative: that of the law. The
  /// last contacts other than those of energies are kept: the tangent at the same places takes them again. Results that
  /// nobody holds any more lend their memory to later ones.
  std::shared_ptr<const Times> contacts(const std::vector<Places>& times, Share share, double range = -1,
                                        const std::vector<Places>& also = {}) const;
  /// Returns them at one displacement.
  std::shared_ptr<const Times> contacts(const double* u, Share share, double range = -1) const;
  /// Returns the point's gap with its derivatives; the contact must have a closest point.
  PairGap<D> gap_of(const Contact& contact) const;
  using Nodes = boost::container::static_vector<int, PairGap<D>::most>;
  /// Returns the local nodes of a contact, in the order of PairGap.
  Nodes nodes_of(const Contact& contact) const { return nodes_of(contact.patch, contact.projection.patch); }
  Nodes nodes_of(std::size_t secondary, int primary) const;
  /// Calls visit(block) for each matrix of the rule's tangent, which is symmetric if the primary surface reacts: one
  /// for each pair of a secondary patch and a primary one with a closest point.
  template <class Visit>
  void for_each_block(const Segment& segment, const Rule& rule, Tangent kind, const Visit& visit) const;

  /// Null unless the surface interacts with itself.
  SelfVisibility<D>* visibility() const { return visibility_.get(); }
  /// Returns the nearest point that a patch of a surface sees of it.
  SurfaceProjection<D> nearest_seen(const PlacedSurface<D>& surface, std::size_t patch, const Vec<D>& place) const {
    const double farthest = std::max(range_, overlap_.depth);
    SurfaceProjection<D> projection = surface.nearest_of(visibility_->seen(patch), place, farthest);
    keep_within(range_, farthest, projection);
    return projection;
  }
  /// Returns whether the law acts at the projection of a point.
  bool acts(const SurfaceProjection<D>& projection) const {
    return projection.patch >= 0 && !(projection.gap >= range_) &&
           !(projection.gap <= -std::max(range_, overlap_.depth));
  }
  /// Makes the gap of a point below a free rim of the primary surface negative if its way to the rim differs from the
  /// normal by 15 degrees or less: else points near an edge where both bodies end would lose their force as the
  /// surfaces turn a little. Only for laws that act on overlaps, not for a surface that interacts with itself.
  void count_below_rim(SurfaceProjection<D>& projection) const;
  /// The overlaps on which the law acts, with the points at which it does.
  const PairOverlap<D>& overlap() const { return overlap_; }
  /// Returns how often the law, with its share, acts on a place of the surface: twice if it interacts with itself.
  double passes() const { return (visibility_ ? 2 : 1) / share_; }
  bool reacts() const { return reacts_; }

  /// Returns quadrature weight times reference length or area, of the ring in a body of revolution, with and without
  /// the factor [L0^(D-1)].
  double measure(const Contact& c) const { return points_[index(c)].measure; }
  double area(const Contact& c) const { return points_[index(c)].area; }
  const typename SurfacePatch<D>::Weights& weights(const Contact& c) const { return points_[index(c)].weights; }
  bool counts(std::size_t patch) const { return secondary().owned[patch] != 0; }
  /// Adds the sides of the secondary surface to those that count; calls visit(patch) for the patches of new ones.
  template <class Visit>
  void count(CountedSides& counted, const Visit& visit) const {
    bool is_new = false;
    for (std::size_t p = 0; p < secondary().patches.size(); ++p) {
      if (secondary().part[p] == 0) is_new = counted.insert(secondary().sides[p]).second;
      if (is_new) visit(p);
    }
  }
  const PairSurfaces<D>& surfaces() const { return surfaces_; }
  const SurfacePatches<D>& secondary() const { return surfaces_.secondary; }
  const SurfacePatches<D>& primary() const { return surfaces_.primary; }
  const PairSearch<D>& search() const { return search_; }
  const GapLaw& law() const { return *law_; }
  bool is_positive() const { return law_->domain() == GapDomain::Positive; }
  std::size_t points_of_a_patch() const { return per_patch_; }
  /// Returns the reference coordinates of the points of a patch, see PointColumns.
  std::vector<std::array<double, 3>> places_along_sides() const;
  std::size_t index(const Contact& c) const { return c.patch * per_patch_ + c.point; }

 private:
  struct Point {
    typename SurfacePatch<D>::Weights weights;
    double measure, area;
  };
  /// The sum of a primary patch's matrix.
  struct OpenBlock {
    PairSums<D> sums;
    PairBlock block;
  };
  void combine(double rest, const NodeParts& parts, Places& at) const;
  std::shared_ptr<Times> unused(std::size_t count) const;
  std::shared_ptr<const PairNeighbours> neighbours(const std::vector<const Places*>& times, double range) const;
  /// The points of a patch at one place of the surface.
  struct PlacedPoints {
    std::vector<Vec<D>> places;
    Vec<D> middle;
    double radius() const;  ///< of a ball around the middle that holds them
  };
  void place_points(std::size_t patch, const Places& at, PlacedPoints& points) const;
  void place_primary(Contacts& contacts) const;
  /// Sets, by entry of the neighbours, whether its points act on nodes of this rank at one of these times.
  void find_acting(const Times& times, double range, std::vector<char>& acting) const;
  /// `looks`: by entry of the neighbours, whether its points count.
  void find_projections(Contacts& contacts, const EarlierProjections<D>& earlier, const std::vector<char>& looks,
                        double range) const;
  /// Discards a closest point whose gap is out of range, because it was searched farther than that, for an overlap.
  static void keep_within(double range, double searched, SurfaceProjection<D>& projection) {
    if (searched > range && projection.patch >= 0 && projection.gap >= range) projection = {};
  }
  /// Returns how far the closest points of an entry's points are searched.
  double search_range(const PairNeighbours& near, std::size_t entry, double range) const {
    return near.is_deep(entry) ? std::max(range, overlap_.depth) : range;
  }
  void evaluate_law(Contacts& contacts) const;
  void add(const Contact& contact, double factor, Tangent kind, std::vector<OpenBlock>& blocks,
           std::size_t& used) const;

  std::vector<double> coordinates_;  ///< of the local mesh
  PairSurfaces<D> surfaces_;
  std::unique_ptr<SelfVisibility<D>> visibility_;
  std::shared_ptr<const GapLaw> law_;
  double range_, share_;
  bool reacts_;
  PairOverlap<D> overlap_;
  std::size_t per_patch_;
  int along_;  ///< points of a patch in each direction
  std::vector<Point> points_;
  std::vector<char> owns_secondary_, owns_primary_;  ///< by patch: some node is this rank's
  // The results of the last search and of the last evaluation save time. Results depend on them by rounding errors at
  // most.
  mutable PairSearch<D> search_;
  mutable std::shared_ptr<const PairNeighbours> seen_;
  mutable long seen_version_ = -1;
  mutable std::shared_ptr<const Times> last_;
  mutable Share last_share_ = Share::Forces;  ///< of `last_`
  mutable double last_range_ = 0;
  /// Memory, so that Newton iterations need no new one.
  struct Memory {
    std::vector<std::shared_ptr<Times>> times;
    std::vector<Places> at_rule, single;
    std::vector<const Places*> covered;
    std::vector<EarlierProjections<D>> earlier;
    std::vector<char> looks;
    PlacedPoints points;
    std::vector<int> nearest;  ///< primary patches
    std::vector<OpenBlock> blocks;
  };
  mutable Memory memory_;
  mutable bool remembers_ = false;  ///< whether closest points begin at those of the last evaluation
};

template <std::size_t D>
template <class Visit>
void PairPoints<D>::for_each_block(const Segment& segment, const Rule& rule, Tangent kind, const Visit& visit) const {
  if (rule.points.empty()) return;
  const auto times = contacts(places(segment, rule), Share::Forces);
  std::vector<OpenBlock>& blocks = memory_.blocks;  // the first `used` ones count
  std::size_t used = 0;
  const std::vector<Contact>& all = times->front().all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < rule.points.size(); ++k)
      if (const double factor = rule.points[k].weight * rule.points[k].to; factor != 0)
        add((*times)[k].all[i], factor, kind, blocks, used);
    for (std::size_t b = 0; b < used; ++b) blocks[b].sums.end_point(weights(all[i]));
    if (i + 1 < all.size() && all[i + 1].patch == all[i].patch) continue;
    for (std::size_t b = 0; b < used; ++b) {
      blocks[b].sums.write(blocks[b].block.k, reacts_);
      visit(blocks[b].block);
    }
    used = 0;
  }
}

extern template double overlap_depth(const LocalMesh&, const SurfacePatches<2>&);
extern template double overlap_depth(const LocalMesh&, const SurfacePatches<3>&);
extern template class PairPoints<2>;
extern template class PairPoints<3>;

}  // namespace ixos
