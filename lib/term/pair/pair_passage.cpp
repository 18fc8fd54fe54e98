#include "term/pair/pair_passage.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>

#include "base/vector3.hpp"
#include "interaction/passage.hpp"

namespace ixos {
namespace {

constexpr double tolerance = 1e-9;  ///< of a facet's coordinates: its edges belong to it

/// A part of a surface that counts as flat: its corners.
template <std::size_t D>
using Facet = std::array<Vec<D>, D>;

/// Returns the outward normal, as long as the facet is large.
Vec<2> normal_of(const Facet<2>& f) { return {f[1][1] - f[0][1], f[0][0] - f[1][0]}; }
Vec<3> normal_of(const Facet<3>& f) { return cross(f[1] - f[0], f[2] - f[0]); }

/// Returns whether the facet holds a point of its plane.
bool holds(const Facet<2>& f, const Vec<2>& x) {
  const Vec<2> e = f[1] - f[0];
  const double share = inner(x - f[0], e) / inner(e, e);
  return share >= -tolerance && share <= 1 + tolerance;
}
bool holds(const Facet<3>& f, const Vec<3>& x) {
  const Vec<3> a = f[1] - f[0], b = f[2] - f[0], r = x - f[0];
  const double aa = inner(a, a), ab = inner(a, b), bb = inner(b, b), ra = inner(r, a), rb = inner(r, b);
  const double det = aa * bb - ab * ab;
  const double first = (bb * ra - ab * rb) / det, second = (aa * rb - ab * ra) / det;
  return first >= -tolerance && second >= -tolerance && first + second <= 1 + tolerance;
}

/// Returns the facets of a patch: one in the plane, two in space.
std::array<Facet<2>, 1> facets_of(const PlacedPatch<2>& patch) { return {{{patch.at({0}), patch.at({1})}}}; }
std::array<Facet<3>, 2> facets_of(const PlacedPatch<3>& patch) {
  const Vec<3> a = patch.at({0, 0}), b = patch.at({1, 0}), c = patch.at({1, 1}), d = patch.at({0, 1});
  return {{{a, b, c}, {a, c, d}}};
}

/// Returns a place between two ones.
template <std::size_t D>
Vec<D> between(const Vec<D>& x0, const Vec<D>& x1, double share) {
  return x0 + share * (x1 - x0);
}

/// A point crosses a surface.
template <std::size_t D>
struct Crossing {
  double time;  ///< as a share of the step
  bool enters;
  Vec<D> normal;  ///< outward unit vector
  int patch = -1;
};

template <std::size_t D>
using Crossings = boost::container::small_vector<Crossing<D>, 8>;

/// Adds the places where the way of a point from x0 to x1 crosses a facet that moves from f0 to f1. Looks at eight
/// parts of the step, in each of which the point changes its side at most once.
template <std::size_t D>
void add_crossings(const Vec<D>& x0, const Vec<D>& x1, const Facet<D>& f0, const Facet<D>& f1, Crossings<D>& all) {
  constexpr int parts = 8, rounds = 50;
  const auto facet_at = [&](double t) {
    Facet<D> f;
    for (std::size_t c = 0; c < D; ++c) f[c] = between(f0[c], f1[c], t);
    return f;
  };
  const auto is_outside = [&](double t) {
    const Facet<D> f = facet_at(t);
    return inner(normal_of(f), between(x0, x1, t) - f[0]) > 0;
  };
  bool outside = is_outside(0);
  for (int k = 0; k < parts; ++k) {
    double low = static_cast<double>(k) / parts, high = static_cast<double>(k + 1) / parts;
    const bool enters = outside;
    outside = is_outside(high);
    if (outside == enters) continue;
    for (int round = 0; round < rounds; ++round) {
      const double middle = (low + high) / 2;
      (is_outside(middle) == enters ? low : high) = middle;
    }
    const Facet<D> f = facet_at(high);
    const Vec<D> n = normal_of(f);
    if (length(n) > 0 && holds(f, between(x0, x1, high))) all.push_back({high, enters, (1 / length(n)) * n, -1});
  }
}

/// A surface in a step.
template <std::size_t D>
struct MovingSurface {
  MovingSurface(const SurfacePatches<D>& surface, const std::vector<Vec<D>>& from, const std::vector<Vec<D>>& to)
      : count(surface.patches.size()), start(surface.patches, from), end(surface.patches, to) {
    for (std::size_t i = 0; i < from.size(); ++i)
      drift = drift + 1 / static_cast<double>(from.size()) * (to[i] - from[i]);
    for (std::size_t i = 0; i < from.size(); ++i) rest.push_back(to[i] - from[i] - drift);
  }

  std::size_t count;  ///< patches
  PlacedSurface<D> start, end;
  Vec<D> drift{};            ///< mean displacement of the nodes [L0]
  std::vector<Vec<D>> rest;  ///< displacements of the nodes less that [L0]
  double strain = 0;         ///< a bound on that of all points [L0]
};

/// The points of one surface and their ways through the other one.
template <std::size_t D>
class Ways {
 public:
  /// `moving`: the surface whose points are looked at; `other`: the one that they can pass; `visibility`: of one
  /// surface.
  Ways(const MovingSurface<D>& moving, const MovingSurface<D>& other, const SelfVisibility<D>* visibility)
      : moving_(moving), other_(other), visibility_(visibility) {}

  /// Lowers the lowest point to the ends of points that pass. `scale`: see has_passed(). `behind(closest point)`:
  /// whether a point that has that closest point at the end is behind the body.
  template <class Behind>
  void lower(double scale, const Behind& behind, LowestPoint& lowest) const {
    for (std::size_t p = 0; p < moving_.count; ++p)
      for (std::size_t i = 0; i < (D == 2 ? 3 : 9); ++i) {
        [[maybe_unused]] const std::size_t row = i / 3;
        PatchParameters<D> xi{0.5 * static_cast<double>(i % 3)};
        if constexpr (D == 3) xi[1] = 0.5 * static_cast<double>(row);
        const Vec<D> x0 = moving_.start.patch(static_cast<int>(p)).at(xi),
                     x1 = moving_.end.patch(static_cast<int>(p)).at(xi);
        if (!(length(x1 - x0 - other_.drift) > scale / 8)) continue;
        const Crossings<D> crossings = find(p, x0, x1);
        if (crossings.empty()) continue;
        const double gap = visibility_ != nullptr ? own_passage(p, crossings, length(x1 - x0 - other_.drift))
                                                  : passage(crossings, x0, x1, scale, behind);
        if (!(gap < lowest.gap)) continue;
        lowest.gap = gap;
        std::copy(x1.begin(), x1.end(), lowest.place.begin());
      }
  }

 private:
  static constexpr double none = std::numeric_limits<double>::infinity();

  /// Returns where the way of a point of a patch crosses the other surface, in the order of time.
  Crossings<D> find(std::size_t p, const Vec<D>& x0, const Vec<D>& x1) const {
    Crossings<D> result;
    for (const int q : other_.start.near(std::array<Vec<D>, 2>{x0, x1 - other_.drift}, other_.strain)) {
      if (visibility_ != nullptr && visibility_->is_excluded(p, q)) continue;
      const auto before = facets_of(other_.start.patch(q)), after = facets_of(other_.end.patch(q));
      const std::size_t found = result.size();
      for (std::size_t f = 0; f < before.size(); ++f) add_crossings<D>(x0, x1, before[f], after[f], result);
      for (std::size_t k = found; k < result.size(); ++k) result[k].patch = q;
    }
    std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    return result;
  }

  /// Returns the first crossing after a time that enters the body, or leaves it; null if there is none.
  static const Crossing<D>* first(const Crossings<D>& all, bool enters, double after) {
    for (const Crossing<D>& crossing : all)
      if (crossing.enters == enters && crossing.time >= after) return &crossing;
    return nullptr;
  }

  /// Returns the least gap that was found on the way of a point that passes through the other body, else infinity.
  template <class Behind>
  double passage(const Crossings<D>& all, const Vec<D>& x0, const Vec<D>& x1, double scale,
                 const Behind& behind) const {
    const SurfaceProjection<D> start = other_.start.nearest(x0), end = other_.end.nearest(x1);
    const Crossing<D>* const in = first(all, true, 0);
    if (start.gap > 0 && in == nullptr) return none;
    const double entered = start.gap > 0 ? in->time : 0;
    const Crossing<D>* const out = first(all, false, entered);
    if (out == nullptr && start.gap > 0 && behind(end)) return end.gap;
    if (out == nullptr && end.gap > 0) return none;  // beside a free rim
    const double left = out != nullptr ? out->time : 1;
    WayThrough way{start.gap, end.gap, length(x1 - x0 - other_.drift), std::min(start.gap, end.gap)};
    constexpr int samples = 8;
    for (int k = 0; k < samples; ++k) {
      const double time = entered + (left - entered) * (k + 0.5) / samples;
      way.deepest = std::min(way.deepest, other_.start.nearest(between(x0, x1 - other_.drift, time)).gap);
    }
    way.turn = inner(start.gap > 0 ? in->normal : start.normal, out != nullptr ? out->normal : end.normal);
    return has_passed(way, scale + other_.strain) ? way.deepest : none;
  }

  /// Returns minus half of the way through another part of the same surface, at most the depth, if the point leaves it
  /// at another side, or if it stays in a part that its patch does not see, which has no force on it; else infinity.
  /// The nearest point of the surface is the point itself: it has no gap.
  double own_passage(std::size_t p, const Crossings<D>& all, double way) const {
    const Crossing<D>* const in = first(all, true, 0);
    if (in == nullptr) return none;
    const Crossing<D>* const out = first(all, false, in->time);
    const std::vector<int>& seen = visibility_->seen(p);
    if (out == nullptr)
      return std::binary_search(seen.begin(), seen.end(), in->patch) ? none : -way * (1 - in->time) / 2;
    if (!(inner(in->normal, out->normal) < 0)) return none;
    return -way * (out->time - in->time) / 2;
  }

  const MovingSurface<D>& moving_;
  const MovingSurface<D>& other_;
  const SelfVisibility<D>* visibility_;
};

}  // namespace

template <std::size_t D>
LowestPoint find_passage(const PairPoints<D>& points, const PairPlaces<D>& from, const PairPlaces<D>& to) {
  LowestPoint lowest;
  const double scale = points.law().equilibrium_gap();
  if (!from.is_finite() || !to.is_finite() || points.search().motion(from, to) <= scale / 8) return lowest;
  MovingSurface<D> secondary(points.secondary(), from.secondary, to.secondary),
      primary(points.primary(), from.primary, to.primary);
  const std::array<double, 2> strains = points.search().fastest({secondary.rest, primary.rest});
  secondary.strain = strains[0];
  primary.strain = strains[1];
  const auto behind = [&](const SurfaceProjection<D>& end) { return end.gap < 0 && !points.acts(end); };
  Ways<D>(secondary, primary, points.visibility()).lower(scale, behind, lowest);
  if (points.visibility() == nullptr)
    Ways<D>(primary, secondary, nullptr)
        .lower(
            scale, [](const SurfaceProjection<D>&) { return false; }, lowest);
  return lowest;
}

template LowestPoint find_passage(const PairPoints<2>&, const PairPlaces<2>&, const PairPlaces<2>&);
template LowestPoint find_passage(const PairPoints<3>&, const PairPlaces<3>&, const PairPlaces<3>&);

}  // namespace ixos
