/// From values that ranks hold in their own order to the order of all.
#pragma once
#include <memory>
#include <vector>

#include "base/tpetra.hpp"
#include "io/hdf5_file.hpp"

namespace ixos {

/// Puts values in the order of their ids, wherever they come from: a rank then holds a slab of them.
class GlobalOrder {
 public:
  /// `ids`: from 1 to `largest`, not all of which need to be there, of the values that this rank brings. What several
  /// ranks bring for one id is the same value. Collective.
  GlobalOrder(const Comm& comm, const std::vector<int>& ids, long long largest);
  ~GlobalOrder();
  GlobalOrder(GlobalOrder&& other) noexcept;
  GlobalOrder& operator=(GlobalOrder&&) = delete;

  const Slab& slab() const { return slab_; }
  /// Of several fields, each by the order of `ids`, the values of this rank's slab. Collective.
  std::vector<std::vector<double>> ordered(const std::vector<std::vector<double>>& fields) const;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
  std::vector<std::size_t> present_;  ///< of this rank's share of the ids: which there are
  Slab slab_;
};

}  // namespace ixos
