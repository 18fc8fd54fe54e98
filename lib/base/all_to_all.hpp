/// Messages from every rank to every other one.
#pragma once
#include <Teuchos_DefaultMpiComm.hpp>
#include <numeric>
#include <type_traits>
#include <vector>

#include "base/tpetra.hpp"

namespace ixos {

/// Sends out[r] to rank r. Returns what arrived here: element r came from rank r. Collective.
template <class T>
std::vector<std::vector<T>> all_to_all(const std::vector<std::vector<T>>& out, const Comm& comm) {
  static_assert(std::is_trivially_copyable_v<T>, "the bytes of a message are its value");
  if (comm->getSize() == 1) return out;
  const MPI_Comm raw = *dynamic_cast<const Teuchos::MpiComm<int>&>(*comm).getRawMpiComm();
  const auto ranks = static_cast<std::size_t>(comm->getSize());
  std::vector<int> sent(ranks), received(ranks), from(ranks, 0), to(ranks, 0);
  std::vector<T> outgoing;
  for (std::size_t r = 0; r < ranks; ++r) {
    sent[r] = static_cast<int>(out[r].size());
    outgoing.insert(outgoing.end(), out[r].begin(), out[r].end());
  }
  MPI_Alltoall(sent.data(), 1, MPI_INT, received.data(), 1, MPI_INT, raw);
  std::partial_sum(sent.begin(), sent.end() - 1, from.begin() + 1);
  std::partial_sum(received.begin(), received.end() - 1, to.begin() + 1);
  std::vector<T> incoming(static_cast<std::size_t>(to.back() + received.back()));
  MPI_Datatype type;
  MPI_Type_contiguous(static_cast<int>(sizeof(T)), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Alltoallv(outgoing.data(), sent.data(), from.data(), type, incoming.data(), received.data(), to.data(), type,
                raw);
  MPI_Type_free(&type);
  std::vector<std::vector<T>> in(ranks);
  for (std::size_t r = 0; r < ranks; ++r)
    in[r].assign(incoming.begin() + to[r], incoming.begin() + to[r] + received[r]);
  return in;
}

/// Returns parts one behind the other.
template <class T>
std::vector<T> joined(const std::vector<std::vector<T>>& parts) {
  std::vector<T> all;
  for (const std::vector<T>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Returns the numbers of all ranks, one behind the other, on each of them. Collective.
template <class T>
std::vector<T> of_all_ranks(const std::vector<T>& mine, const Comm& comm) {
  return joined(all_to_all(std::vector<std::vector<T>>(static_cast<std::size_t>(comm->getSize()), mine), comm));
}

}  // namespace ixos
