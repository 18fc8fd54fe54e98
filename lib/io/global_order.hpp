/// Sorting values that ranks hold in their own order into the global order.
#pragma once
#include <memory>
#include <vector>

#include "base/tpetra.hpp"
#include "io/hdf5_file.hpp"

namespace ixos {

/// A sorter of values by their ids, whichever rank holds them: each rank then holds a slab of them.
class GlobalOrder {
 public:
  /// `ids` are those of this rank's values, from 1 to `largest`; some ids may be missing. If several ranks pass one id,
  /// they pass the same value. Collective.
  GlobalOrder(const Comm& comm, const std::vector<int>& ids, long long largest);
  ~GlobalOrder();
  GlobalOrder(GlobalOrder&& other) noexcept;
  GlobalOrder& operator=(GlobalOrder&&) = delete;

  const Slab& slab() const { return slab_; }
  /// Returns this rank's slab of the values of several fields, each given in the order of `ids`. Collective.
  std::vector<std::vector<double>> ordered(const std::vector<std::vector<double>>& fields) const;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
  std::vector<std::size_t> present_;  ///< of this rank's share of the ids: the existing ones
  Slab slab_;
};

}  // namespace ixos
