#include "mesh/node_ties.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

void NodeTies::add(const std::vector<Share>& shares) {
  shares_.insert(shares_.end(), shares.begin(), shares.end());
  start_.push_back(shares_.size());
}

void NodeTies::interpolate(double* values, std::size_t count) const {
  for (int node = first_; node < first_ + size(); ++node) {
    double* const own = values + static_cast<std::size_t>(node) * count;
    std::fill_n(own, count, 0.0);
    for (const Share* share = begin(node); share != end(node); ++share) {
      const double* const master = values + static_cast<std::size_t>(share->master) * count;
      for (std::size_t i = 0; i < count; ++i) own[i] += share->weight * master[i];
    }
  }
}

template <class Factor>
void NodeTies::condense_with(double* values, std::size_t count, const Factor& factor) const {
  for (int node = first_; node < first_ + size(); ++node) {
    double* const own = values + static_cast<std::size_t>(node) * count;
    for (const Share* share = begin(node); share != end(node); ++share) {
      double* const master = values + static_cast<std::size_t>(share->master) * count;
      for (std::size_t i = 0; i < count; ++i) master[i] += factor(share->weight) * own[i];
    }
    std::fill_n(own, count, 0.0);
  }
}

void NodeTies::condense(double* forces, std::size_t count) const {
  condense_with(forces, count, [](double weight) { return weight; });
}

void NodeTies::condense_magnitudes(double* sums, std::size_t count) const {
  condense_with(sums, count, [](double weight) { return std::abs(weight); });
}

void NodeTies::condense_diagonal(double* diagonal, std::size_t count) const {
  condense_with(diagonal, count, [](double weight) { return weight * weight; });
}

double NodeTies::largest_magnitude() const {
  double largest = 1;
  for (int node = first_; node < first_ + size(); ++node) {
    double sum = 0;
    for (const Share* share = begin(node); share != end(node); ++share) sum += std::abs(share->weight);
    largest = std::max(largest, sum);
  }
  return largest;
}

}  // namespace ixos
