/// Gathering the arrays of all ranks on the first one.
#pragma once
#include <Teuchos_DefaultMpiComm.hpp>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/tpetra.hpp"

namespace ixos {

inline MPI_Datatype mpi_type(const int*) { return MPI_INT; }
inline MPI_Datatype mpi_type(const double*) { return MPI_DOUBLE; }
inline MPI_Datatype mpi_type(const std::uint64_t*) { return MPI_UINT64_T; }

/// Returns the values of all ranks, one rank after the other, on the first rank; nothing elsewhere. Collective.
template <class T>
std::vector<T> gather(const std::vector<T>& mine, const Comm& comm) {
  if (comm->getSize() == 1) return mine;
  const MPI_Comm raw = *dynamic_cast<const Teuchos::MpiComm<int>&>(*comm).getRawMpiComm();
  const auto ranks = static_cast<std::size_t>(comm->getSize());
  const auto length = static_cast<int>(mine.size());
  std::vector<int> lengths(ranks), offsets(ranks, 0);
  MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, raw);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  std::vector<T> all(comm->getRank() == 0 ? static_cast<std::size_t>(offsets.back() + lengths.back()) : 0);
  const MPI_Datatype type = mpi_type(mine.data());
  MPI_Gatherv(mine.data(), length, type, all.data(), lengths.data(), offsets.data(), type, 0, raw);
  return all;
}

}  // namespace ixos
