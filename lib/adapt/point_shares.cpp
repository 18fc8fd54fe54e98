#include "adapt/point_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "base/small_matrix.hpp"

namespace ixos {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Barycentric coordinates, whose distances depend on no order of the corners.
using Place = std::array<double, 4>;

Place difference(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]}; }
double product(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

/// A simplex of some of the points, and what is next to a place there.
struct Candidate {
  std::vector<ShareOfPoint> shares;
  double distance, size;  ///< squares: to the place, and the sum of the edges
};

/// Returns the shares of the corners of a simplex of `Edges` edges from its first one in the point of its plane that is
/// next to a place; nothing if that is outside, or the simplex is flat.
template <std::size_t Edges>
std::optional<Candidate> nearest_in(const std::vector<Place>& points, const std::vector<std::size_t>& corners,
                                    const Place& place) {
  std::array<Place, Edges> edge;
  const Place& first = points[corners[0]];
  const Place way = difference(place, first);
  for (std::size_t k = 0; k < Edges; ++k) edge[k] = difference(points[corners[k + 1]], first);
  Candidate found{{{corners[0], 1}}, 0, 0};
  Place rest = way;
  if constexpr (Edges > 0) {
    Small<double, Edges> gram;
    double scale = 1;
    for (std::size_t i = 0; i < Edges; ++i) {
      for (std::size_t j = 0; j < Edges; ++j) gram[i][j] = product(edge[i], edge[j]);
      scale *= gram[i][i];
    }
    const double det = determinant(gram);
    if (!(det > 1e-12 * scale)) return std::nullopt;
    Small<double, Edges> inverse;
    if constexpr (Edges == 1)
      inverse[0][0] = 1 / gram[0][0];
    else
      inverse = ixos::inverse(gram, det);
    for (std::size_t i = 0; i < Edges; ++i) {
      double share = 0;
      for (std::size_t j = 0; j < Edges; ++j) share += inverse[i][j] * product(edge[j], way);
      found.shares.push_back({corners[i + 1], share});
      found.shares.front().weight -= share;
      for (std::size_t k = 0; k < 4; ++k) rest[k] -= share * edge[i][k];
    }
  }
  for (ShareOfPoint& share : found.shares) {
    if (share.weight < -same_place) return std::nullopt;
    share.weight = std::max(share.weight, 0.0);
  }
  found.distance = product(rest, rest);
  for (std::size_t a = 0; a < corners.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const Place own = difference(points[corners[a]], points[corners[b]]);
      found.size += product(own, own);
    }
  return found;
}

std::optional<Candidate> nearest_in(const std::vector<Place>& points, const std::vector<std::size_t>& corners,
                                    const Place& place) {
  switch (corners.size()) {
    case 1:
      return nearest_in<0>(points, corners, place);
    case 2:
      return nearest_in<1>(points, corners, place);
    case 3:
      return nearest_in<2>(points, corners, place);
    default:
      return nearest_in<3>(points, corners, place);
  }
}

/// Keeps the candidates that are next to the place, of these the smallest ones.
class Best {
 public:
  void offer(Candidate candidate) {
    constexpr double tiny = 1e-18, equal = 1e-9;
    const auto is_less = [](double a, double b) { return a < (1 - equal) * b - tiny; };
    if (!all_.empty()) {
      const Candidate& best = all_.front();
      if (is_less(best.distance, candidate.distance)) return;
      if (!is_less(candidate.distance, best.distance)) {
        if (is_less(best.size, candidate.size)) return;
        if (!is_less(candidate.size, best.size)) return all_.push_back(std::move(candidate));
      }
    }
    all_.clear();
    all_.push_back(std::move(candidate));
  }
  bool none() const { return all_.empty(); }

  std::vector<ShareOfPoint> mean(std::size_t points) const {
    std::vector<double> weight(points, 0.0);
    double sum = 0;
    for (const Candidate& candidate : all_)
      for (const ShareOfPoint& share : candidate.shares) weight[share.point] += share.weight;
    for (const double own : weight) sum += own;
    std::vector<ShareOfPoint> shares;
    for (std::size_t point = 0; point < points; ++point)
      if (weight[point] > 0) shares.push_back({point, weight[point] / sum});
    return shares;
  }

 private:
  std::vector<Candidate> all_;
};

/// Calls visit(corners) for all subsets of that size.
template <class Visit>
void for_each_subset(std::size_t points, std::size_t size, const Visit& visit) {
  if (size > points) return;
  std::vector<std::size_t> corners(size);
  for (std::size_t k = 0; k < size; ++k) corners[k] = k;
  while (true) {
    visit(corners);
    std::size_t k = size;
    while (k > 0 && corners[k - 1] == points - size + k - 1) --k;
    if (k == 0) return;
    ++corners[k - 1];
    for (std::size_t next = k; next < size; ++next) corners[next] = corners[next - 1] + 1;
  }
}

/// Returns the points that are near a place, and those with the largest and the least share of each corner, around it:
/// the subsets of all points may be too many.
std::vector<std::size_t> near_and_outermost(const std::vector<Place>& places,
                                            std::vector<std::pair<double, std::size_t>> by_distance,
                                            std::size_t corners) {
  constexpr std::size_t few = 16, near = 8;
  std::set<std::size_t> chosen;
  std::sort(by_distance.begin(), by_distance.end());
  for (const auto& [distance, q] : by_distance)
    if (places.size() <= few || chosen.size() < near || distance <= (1 + 1e-9) * by_distance[near - 1].first)
      chosen.insert(q);
  for (std::size_t corner = 0; corner < corners; ++corner) {
    const auto less = [corner](const Place& a, const Place& b) { return a[corner] < b[corner]; };
    const auto [least, most] = std::minmax_element(places.begin(), places.end(), less);
    for (const auto& outermost : {least, most}) chosen.insert(static_cast<std::size_t>(outermost - places.begin()));
  }
  return {chosen.begin(), chosen.end()};
}

}  // namespace

std::vector<ShareOfPoint> shares_in_grid(const std::vector<RootPlace>& grid, const RootPlace& at) {
  struct Neighbour {
    double coordinate, weight;
  };
  std::array<std::vector<Neighbour>, 3> along;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double below = -HUGE_VAL, above = HUGE_VAL;
    for (const RootPlace& known : grid) {
      const double x = known[axis];
      if (x <= at[axis] + same_place) below = std::max(below, x);
      if (x >= at[axis] - same_place) above = std::min(above, x);
    }
    if (below == -HUGE_VAL) below = above;
    if (above == HUGE_VAL || above - below <= 2 * same_place) above = below;
    const double share = above == below ? 0 : (at[axis] - below) / (above - below);
    along[axis].push_back({below, 1 - share});
    if (share > 0) along[axis].push_back({above, share});
  }
  std::vector<ShareOfPoint> shares;
  for (std::size_t q = 0; q < grid.size(); ++q) {
    double weight = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto found = std::find_if(along[axis].begin(), along[axis].end(), [&](const Neighbour& neighbour) {
        return std::abs(neighbour.coordinate - grid[q][axis]) <= same_place;
      });
      weight *= found == along[axis].end() ? 0 : found->weight;
    }
    if (weight > 0) shares.push_back({q, weight});
  }
  return shares;
}

std::vector<ShareOfPoint> shares_in_simplex(const std::vector<RootPlace>& points, int dimension, int along,
                                            const RootPlace& at) {
  std::vector<std::pair<double, std::size_t>> by_distance;
  std::vector<Place> places;
  const Place place = barycentric(at, dimension);
  for (std::size_t q = 0; q < points.size(); ++q) {
    places.push_back(barycentric(points[q], dimension));
    const Place way = difference(places.back(), place);
    by_distance.emplace_back(product(way, way), q);
    if (by_distance.back().first <= same_place * same_place) return {{q, 1}};
  }
  const std::vector<std::size_t> chosen = near_and_outermost(places, std::move(by_distance), index(dimension) + 1);
  Best best;
  const auto offer_all = [&](std::size_t size) {
    std::vector<std::size_t> corners(size);
    for_each_subset(chosen.size(), size, [&](const std::vector<std::size_t>& subset) {
      for (std::size_t k = 0; k < size; ++k) corners[k] = chosen[subset[k]];
      if (auto found = nearest_in(places, corners, place)) best.offer(std::move(*found));
    });
  };
  offer_all(index(along) + 1);
  if (best.none())
    for (std::size_t size = index(along); size > 0; --size) offer_all(size);
  return best.mean(points.size());
}

}  // namespace ixos
