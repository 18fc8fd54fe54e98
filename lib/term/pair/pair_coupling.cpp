#include "term/pair/pair_coupling.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

/// Returns the components of all places, one after the other.
template <std::size_t D>
std::vector<double> flat(const typename PairPoints<D>::Places& places) {
  std::vector<double> result;
  for (const auto* x : {&places.secondary, &places.primary})
    for (const Vec<D>& place : *x) result.insert(result.end(), place.begin(), place.end());
  return result;
}

}  // namespace

double reach_of_stiffness(const GapLaw& law) {
  const double equilibrium = law.equilibrium_gap(), most = std::min(law.range(), 100 * equilibrium);
  double largest = 0, reach = equilibrium;
  for (int k = 0; equilibrium * std::pow(1.05, k) < most; ++k) {
    const double gap = equilibrium * std::pow(1.05, k);
    const double stiffness = std::abs(law.stiffness(gap)[0]);
    largest = std::max(largest, stiffness);
    if (stiffness > 1e-3 * largest) reach = 1.05 * gap;
  }
  return std::min(reach, most);
}

template <std::size_t D>
PairCoupling<D>::PairCoupling(const PairPoints<D>& points)
    : points_(points), reach_(reach_of_stiffness(points.law())), skin_(reach_ / 2) {
  if (points.visibility() != nullptr) return;  // every point is on the surface
  overlap_ = points.overlap();
  overlap_.least = reach_;
}

template <std::size_t D>
std::vector<std::pair<int, int>> PairCoupling<D>::pairs_within(const typename PairPoints<D>::Places& places,
                                                               double range) const {
  const auto near = find_neighbours(points_.surfaces(), places, range, overlap_, skin_);
  std::vector<Pair> result;
  for (std::size_t k = 0; k < near->secondary.size(); ++k)
    for (const int p : near->primary[k])
      if (points_.visibility() == nullptr || !points_.visibility()->is_excluded(near->secondary[k], p))
        result.emplace_back(static_cast<int>(near->secondary[k]), p);
  return result;
}

/// Returns a bound on how much less a gap can be than at the last search: twice the largest displacement since, less
/// the mean one of all nodes, which no gap notices. Between the nodes, smooth surfaces move by up to 1.6 times as much;
/// where sides of high order move more, the matrix lacks an entry for a while.
template <std::size_t D>
double PairCoupling<D>::motion(const typename PairPoints<D>::Places& places) const {
  const auto for_each_way = [&](const auto& visit) {
    const double* before = last_.data();
    for (const auto* x : {&places.secondary, &places.primary})
      for (const Vec<D>& place : *x) {
        Vec<D> way;
        for (std::size_t i = 0; i < D; ++i) way[i] = place[i] - *before++;
        visit(way);
      }
  };
  const double count = static_cast<double>(last_.size()) / D;
  Vec<D> mean{};
  for_each_way([&](const Vec<D>& way) { mean = mean + 1 / count * way; });
  double largest = 0;
  for_each_way([&](const Vec<D>& way) { largest = std::max(largest, length(way - mean)); });
  return 2 * 1.6 * largest;
}

template <std::size_t D>
bool PairCoupling<D>::update(const typename PairPoints<D>::Places& places) {
  const bool loaded = std::exchange(loaded_, false);
  if (!loaded && std::exchange(join_due_, false)) anew_ = joined_ = true;
  if (std::exchange(anew_, false)) return true;
  if (loaded) return false;
  const bool first = last_.empty();
  if (!places.is_finite() || (!first && motion(places) < skin_)) return false;
  ++searches_;
  last_ = flat<D>(places);
  std::vector<Pair> near = pairs_within(places, reach_ + skin_);
  const bool same = first ? near == pairs_ : std::includes(pairs_.begin(), pairs_.end(), near.begin(), near.end());
  if (!same) pairs_ = std::move(near);
  return !same;
}

template <std::size_t D>
std::vector<std::vector<int>> PairCoupling<D>::stencils() const {
  std::vector<std::vector<int>> result;
  result.reserve(pairs_.size());
  int last = -1;
  for (const Pair& pair : pairs_) {
    const auto nodes = points_.nodes_of(static_cast<std::size_t>(pair.first), pair.second);
    if (joined_ && pair.first == last)
      result.back().insert(result.back().end(), nodes.begin(), nodes.end());
    else
      result.emplace_back(nodes.begin(), nodes.end());
    last = pair.first;
  }
  return result;
}

template <std::size_t D>
bool PairCoupling<D>::covers(const PairBlock& block) const {
  const auto has = [&](int primary) {
    return std::binary_search(pairs_.begin(), pairs_.end(), Pair(static_cast<int>(block.secondary), primary));
  };
  return has(block.primary) && (block.next < 0 || (joined_ && has(block.next)));
}

template <std::size_t D>
void PairCoupling<D>::transfer(Record& record) {
  if (record.loading() && !record.same_partition()) return begin_anew();
  std::vector<double> pairs;
  for (const Pair& pair : pairs_) pairs.insert(pairs.end(), {double(pair.first), double(pair.second)});
  const bool joined_before = joined_;
  record.number("joined", joined_);
  record.number("join due", join_due_);
  record.share("coupled patches", pairs);
  record.share("places of the last search", last_);
  if (!record.loading()) return;
  const auto patches = [](const SurfacePatches<D>& surface) { return static_cast<double>(surface.patches.size()); };
  const std::size_t size = D * (points_.secondary().nodes.size() + points_.primary().nodes.size());
  bool sound = pairs.size() % 2 == 0 && (last_.empty() || last_.size() == size);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    sound = sound && pairs[k] >= 0 && pairs[k] == std::trunc(pairs[k]) &&
            pairs[k] < (k % 2 == 0 ? patches(points_.secondary()) : patches(points_.primary()));
  if (!sound) throw InputError("the coupled patches are not those of the surfaces");
  const std::vector<Pair> before = std::exchange(pairs_, {});
  for (std::size_t k = 0; k < pairs.size(); k += 2)
    pairs_.emplace_back(static_cast<int>(pairs[k]), static_cast<int>(pairs[k + 1]));
  std::sort(pairs_.begin(), pairs_.end());
  anew_ = pairs_ != before || joined_ != joined_before;
  loaded_ = true;
}

template class PairCoupling<2>;
template class PairCoupling<3>;

}  // namespace ixos
