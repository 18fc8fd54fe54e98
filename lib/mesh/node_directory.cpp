#include "mesh/node_directory.hpp"

#include <fmt/format.h>

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <limits>

#include "base/agreement.hpp"
#include "base/all_to_all.hpp"
#include "base/error.hpp"

namespace ixos {
namespace {

bool has_lesser_id(const NodeEntry& a, const NodeEntry& b) { return a.id < b.id; }

template <class T>
T reduce(const Comm& comm, Teuchos::EReductionType type, T mine) {
  T result = mine;
  Teuchos::reduceAll<int, T>(*comm, type, 1, &mine, &result);
  return result;
}

}  // namespace

NodeDirectory::NodeDirectory(const std::vector<long long>& ids, const std::vector<double>& coordinates, int dimension,
                             const Comm& comm)
    : comm_(comm) {
  const auto [least, largest] = std::minmax_element(ids.begin(), ids.end());
  first_ = reduce(comm, Teuchos::REDUCE_MIN, ids.empty() ? std::numeric_limits<long long>::max() : *least);
  const long long last = reduce(comm, Teuchos::REDUCE_MAX, ids.empty() ? -1LL : *largest);
  if (last < 0) throw InputError("the mesh has no nodes");
  const auto ranks = static_cast<std::size_t>(comm->getSize());
  width_ = static_cast<unsigned long long>(last - first_) / ranks + 1;

  std::vector<std::vector<NodeEntry>> out(ranks);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    NodeEntry entry{ids[i], -1, comm->getRank(), static_cast<int>(i), {}};
    for (std::size_t k = 0; k < d; ++k) entry.x[k] = coordinates[i * d + k];
    out[keeper(ids[i])].push_back(entry);
  }
  kept_ = joined(all_to_all(out, comm));
  std::stable_sort(kept_.begin(), kept_.end(), has_lesser_id);
  together<InputError>(comm, [&] {
    const auto twice = std::adjacent_find(kept_.begin(), kept_.end(),
                                          [](const NodeEntry& a, const NodeEntry& b) { return a.id == b.id; });
    if (twice != kept_.end())
      throw InputError(fmt::format("node {} is owned twice, by rank {} and by rank {}; one rank must own it", twice->id,
                                   twice->owner, std::next(twice)->owner));
  });
  const auto mine = static_cast<long long>(kept_.size());
  long long until = mine;
  Teuchos::scan(*comm, Teuchos::REDUCE_SUM, 1, &mine, &until);
  for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i].number = until - mine + static_cast<long long>(i);
  size_ = reduce(comm, Teuchos::REDUCE_SUM, mine);
}

std::size_t NodeDirectory::keeper(long long id) const {
  const auto last = static_cast<std::size_t>(comm_->getSize()) - 1;
  if (id < first_) return 0;
  return std::min(last, static_cast<std::size_t>(static_cast<unsigned long long>(id - first_) / width_));
}

std::vector<std::vector<long long>> NodeDirectory::ask(const std::vector<long long>& ids) const {
  std::vector<std::vector<long long>> out(static_cast<std::size_t>(comm_->getSize()));
  for (const long long id : ids) out[keeper(id)].push_back(id);
  return all_to_all(out, comm_);
}

std::vector<NodeEntry> NodeDirectory::find(const std::vector<long long>& ids) const {
  std::vector<std::vector<NodeEntry>> replies;
  for (const std::vector<long long>& from : ask(ids)) {
    replies.emplace_back();
    for (const long long id : from) {
      const NodeEntry wanted{id, -1, -1, -1, {}};
      const auto found = std::lower_bound(kept_.begin(), kept_.end(), wanted, has_lesser_id);
      replies.back().push_back(found != kept_.end() && found->id == id ? *found : wanted);
    }
  }
  const std::vector<std::vector<NodeEntry>> answers = all_to_all(replies, comm_);
  std::vector<std::size_t> next(answers.size(), 0);  // each keeper answers in the order of the questions
  std::vector<NodeEntry> result;
  result.reserve(ids.size());
  for (const long long id : ids) result.push_back(answers[keeper(id)][next[keeper(id)]++]);
  return result;
}

std::vector<std::vector<int>> NodeDirectory::find_members(const std::vector<SetMember>& members, std::size_t sets,
                                                          const std::vector<long long>& ids) const {
  std::vector<std::vector<SetMember>> out(static_cast<std::size_t>(comm_->getSize()));
  for (const SetMember& member : members) out[keeper(member.id)].push_back(member);
  std::vector<SetMember> known = joined(all_to_all(out, comm_));
  const auto before = [](const SetMember& a, const SetMember& b) {
    return std::pair(a.id, a.set) < std::pair(b.id, b.set);
  };
  std::sort(known.begin(), known.end(), before);
  known.erase(std::unique(known.begin(), known.end(),
                          [](const SetMember& a, const SetMember& b) { return a.id == b.id && a.set == b.set; }),
              known.end());

  std::vector<std::vector<SetMember>> replies;
  for (const std::vector<long long>& from : ask(ids)) {
    replies.emplace_back();
    for (const long long id : from)
      for (auto at = std::lower_bound(known.begin(), known.end(), SetMember{id, -1}, before);
           at != known.end() && at->id == id; ++at)
        replies.back().push_back(*at);
  }
  const std::vector<std::vector<SetMember>> answers = all_to_all(replies, comm_);
  std::vector<std::size_t> next(answers.size(), 0);
  std::vector<std::vector<int>> result(sets);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::size_t rank = keeper(ids[i]);
    for (; next[rank] < answers[rank].size() && answers[rank][next[rank]].id == ids[i]; ++next[rank])
      result[static_cast<std::size_t>(answers[rank][next[rank]].set)].push_back(static_cast<int>(i));
  }
  return result;
}

}  // namespace ixos
