#include "term/pair/self_visibility.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>

#include "base/error.hpp"

namespace ixos {
namespace {

template <std::size_t D>
PatchParameters<D> middle() {
  PatchParameters<D> xi;
  xi.fill(0.5);
  return xi;
}

}  // namespace

template <std::size_t D>
SelfVisibility<D>::SelfVisibility(const std::vector<SurfacePatch<D>>& patches, const std::vector<Vec<D>>& x,
                                  double exclusion, double range)
    : patches_(patches), range_(range), excluded_(patches.size()), seen_(patches.size()) {
  const PlacedSurface<D> placed(patches, x);
  std::vector<Vec<D>> middles;
  for (std::size_t p = 0; p < patches.size(); ++p) middles.push_back(placed.patch(static_cast<int>(p)).at(middle<D>()));
  exclude(middles, exclusion);
}

/// Goes from middle to middle of patches that share a corner, the shortest way first (Dijkstra 1959).
template <std::size_t D>
void SelfVisibility<D>::exclude(const std::vector<Vec<D>>& middles, double exclusion) {
  constexpr std::size_t corners = SurfacePatch<D>::corners;
  using Entry = std::pair<double, int>;
  const auto at = [](int number) { return static_cast<std::size_t>(number); };
  std::map<typename SurfacePatch<D>::Corner, std::vector<int>> patches_of;
  for (std::size_t p = 0; p < patches_.size(); ++p)
    for (std::size_t c = 0; c < corners; ++c) patches_of[patches_[p].corner(c)].push_back(static_cast<int>(p));
  std::vector<double> distance(patches_.size(), HUGE_VAL);
  for (std::size_t start = 0; start < patches_.size(); ++start) {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
    next.push({0, static_cast<int>(start)});
    distance[start] = 0;
    std::vector<int> reached{static_cast<int>(start)};
    while (!next.empty()) {
      const auto [far, patch] = next.top();
      next.pop();
      if (far > distance[at(patch)]) continue;
      for (std::size_t c = 0; c < corners; ++c)
        for (const int other : patches_of[patches_[at(patch)].corner(c)]) {
          const double own = far + length(middles[at(other)] - middles[at(patch)]);
          if (own >= exclusion || own >= distance[at(other)]) continue;
          if (distance[at(other)] == HUGE_VAL) reached.push_back(other);
          distance[at(other)] = own;
          next.push({own, other});
        }
    }
    for (const int patch : reached) distance[at(patch)] = HUGE_VAL;
    std::sort(reached.begin(), reached.end());
    excluded_[start] = std::move(reached);
  }
}

template <std::size_t D>
bool SelfVisibility<D>::is_excluded(std::size_t patch, int other) const {
  return std::binary_search(excluded_[patch].begin(), excluded_[patch].end(), other);
}

template <std::size_t D>
std::vector<std::vector<int>> SelfVisibility<D>::find(const std::vector<Vec<D>>& x, double skin,
                                                      const std::vector<std::vector<int>>* before) const {
  std::vector<std::vector<int>> all(patches_.size());
  const PlacedSurface<D> placed(patches_, x);
  std::vector<Vec<D>> places, normals;
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const auto frame = placed.patch(static_cast<int>(p)).frame(middle<D>());
    places.push_back(frame.place);
    normals.push_back(PlacedPatch<D>::normal(frame));
  }
  const auto way = [&](std::size_t p, std::size_t q) { return places[q] - places[p]; };
  const auto face = [&](std::size_t p, std::size_t q) {
    return inner(way(p, q), normals[p]) > 0 && inner(way(p, q), normals[q]) < 0;
  };
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    std::vector<int> seen;
    const std::vector<int> near = placed.near(placed.patch(static_cast<int>(p)).hull(), range_ + skin);
    for (const int other : near)
      if (face(p, static_cast<std::size_t>(other)) && !is_excluded(p, other)) seen.push_back(other);
    if (before != nullptr && p < before->size()) {
      for (const int other : (*before)[p]) {
        const auto q = static_cast<std::size_t>(other);
        if (face(p, q) || !(inner(normals[p], normals[q]) < 0)) continue;
        const bool behind = inner(way(p, q), normals[p]) < 0 && inner(way(p, q), normals[q]) > 0;
        if (behind || std::binary_search(near.begin(), near.end(), other)) seen.push_back(other);
      }
      std::sort(seen.begin(), seen.end());
    }
    all[p] = std::move(seen);
  }
  return all;
}

template <std::size_t D>
void SelfVisibility<D>::transfer(Record& record, std::vector<std::vector<int>>& seen) {
  const char* const name = "patches that see each other";
  std::vector<double> flat;  // the number of each patch's, then these
  for (const std::vector<int>& own : seen) {
    flat.push_back(static_cast<double>(own.size()));
    flat.insert(flat.end(), own.begin(), own.end());
  }
  if (!record.loading() || record.in_memory()) {
    record.share(name, flat);
    if (!record.loading()) return;
  } else {
    record.all_shares(name, flat);  // each rank wrote the same
  }
  std::size_t place = 0;
  bool sound = true;
  const auto number = [&](double below) {
    const double value = place < flat.size() ? flat[place++] : -1;
    sound = sound && value >= 0 && value < below && value == std::trunc(value);
    return sound ? static_cast<int>(value) : 0;
  };
  for (std::vector<int>& own : seen) {
    own.clear();
    const int count = number(static_cast<double>(flat.size()));
    for (int k = 0; k < count && sound; ++k) own.push_back(number(static_cast<double>(seen.size())));
    sound = sound && std::is_sorted(own.begin(), own.end());
  }
  if (!sound) throw InputError("the patches that see each other are not those of the surface");
}

template class SelfVisibility<2>;
template class SelfVisibility<3>;

}  // namespace ixos
