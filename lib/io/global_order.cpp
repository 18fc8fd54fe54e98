#include "io/global_order.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Export.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <algorithm>
#include <numeric>

namespace ixos {

/// The ids in equal shares, one after the other, and the communication that brings the values there.
struct GlobalOrder::Plan {
  Plan(const Comm& comm, const std::vector<GlobalId>& ids, long long largest)
      : here(Teuchos::rcp(new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(), ids, 0, comm))),
        shares(Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(largest), 0, comm))),
        way(here, shares) {}
  Teuchos::RCP<const Map> here, shares;
  Tpetra::Export<LocalId, GlobalId> way;
};

GlobalOrder::GlobalOrder(const Comm& comm, const std::vector<int>& ids, long long largest) {
  std::vector<GlobalId> from_zero(ids.begin(), ids.end());
  for (GlobalId& id : from_zero) --id;
  plan_ = std::make_unique<Plan>(comm, from_zero, largest);
  const std::size_t share = static_cast<std::size_t>(plan_->shares->getMaxLocalIndex()) + 1;  // -1 without ids
  present_.resize(share);
  std::iota(present_.begin(), present_.end(), std::size_t{0});
  const std::vector<double> flags = ordered({std::vector<double>(ids.size(), 1.0)})[0];
  present_.clear();
  for (std::size_t i = 0; i < share; ++i)
    if (flags[i] != 0) present_.push_back(i);
  const auto mine = static_cast<long long>(present_.size());
  long long until = 0, total = 0;
  Teuchos::scan(*comm, Teuchos::REDUCE_SUM, 1, &mine, &until);
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_SUM, 1, &mine, &total);
  slab_ = {static_cast<unsigned long long>(until - mine), present_.size(), static_cast<unsigned long long>(total)};
}

GlobalOrder::~GlobalOrder() = default;
GlobalOrder::GlobalOrder(GlobalOrder&&) noexcept = default;

std::vector<std::vector<double>> GlobalOrder::ordered(const std::vector<std::vector<double>>& fields) const {
  MultiVector from(plan_->here, fields.size(), false), to(plan_->shares, fields.size(), true);
  for (std::size_t f = 0; f < fields.size(); ++f)
    std::copy(fields[f].begin(), fields[f].end(), from.getDataNonConst(f).begin());
  to.doExport(from, plan_->way, Tpetra::INSERT);
  std::vector<std::vector<double>> values(fields.size());
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const auto all = to.getData(f);
    values[f].reserve(present_.size());
    for (std::size_t i : present_) values[f].push_back(all[static_cast<Teuchos::ArrayRCP<double>::size_type>(i)]);
  }
  return values;
}

}  // namespace ixos
