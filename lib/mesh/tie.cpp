#include "mesh/tie.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <unordered_map>

#include "base/error.hpp"

namespace ixos {
namespace {

class Resolver {
 public:
  Resolver(const std::vector<Tie>& ties, const std::function<std::string(int)>& name) : ties_(ties), name_(name) {
    for (std::size_t k = 0; k < ties.size(); ++k) {
      if (!tie_of_.insert({ties[k].node, k}).second)
        throw InputError(name(ties[k].node) + " is tied twice; a node may follow one set of others");
      if (ties[k].masters.empty()) throw InputError(name(ties[k].node) + " is tied to nothing");
    }
    state_.resize(ties.size(), State::Open);
    shares_.resize(ties.size());
  }

  std::vector<Tie> all() {
    std::vector<Tie> result;
    for (std::size_t k = 0; k < ties_.size(); ++k) {
      resolve(k);
      Tie& tie = result.emplace_back();
      tie.node = ties_[k].node;
      for (const auto& [master, weight] : shares_[k]) {
        if (std::abs(weight) < 1e-14) continue;  // shares that cancel each other
        tie.masters.push_back(master);
        tie.weights.push_back(weight);
      }
    }
    std::sort(result.begin(), result.end(), [](const Tie& a, const Tie& b) { return a.node < b.node; });
    return result;
  }

 private:
  enum class State : char { Open, Begun, Done };

  void resolve(std::size_t k) {
    if (state_[k] == State::Done) return;
    if (state_[k] == State::Begun)
      throw InputError(name_(ties_[k].node) + " follows itself through the nodes that it is tied to");
    state_[k] = State::Begun;
    std::map<int, double> shares;
    for (std::size_t m = 0; m < ties_[k].masters.size(); ++m) {
      const int master = ties_[k].masters[m];
      const double weight = ties_[k].weights[m];
      const auto tied = tie_of_.find(master);
      if (tied == tie_of_.end()) {
        shares[master] += weight;
        continue;
      }
      resolve(tied->second);
      for (const auto& [further, share] : shares_[tied->second]) shares[further] += weight * share;
    }
    shares_[k] = std::move(shares);
    state_[k] = State::Done;
  }

  const std::vector<Tie>& ties_;
  const std::function<std::string(int)>& name_;
  std::unordered_map<int, std::size_t> tie_of_;
  std::vector<State> state_;
  std::vector<std::map<int, double>> shares_;
};

}  // namespace

std::vector<Tie> resolved_ties(const std::vector<Tie>& ties, const std::function<std::string(int)>& name) {
  return Resolver(ties, name).all();
}

}  // namespace ixos
