// Counts what a program sends by MPI: a library to be loaded before MPI's own.
//
//   mpirun -np 2 -x LD_PRELOAD=libmessage_counter.so -x MESSAGE_COUNTS=counts.json program ...
//
// Wraps the calls by MPI's profiling interface, those from Fortran (MUMPS) too. At MPI_Finalize the first rank writes a
// JSON object of lists by rank: messages and bytes sent from point to point, and calls and this rank's bytes of each
// kind of collective operation. Communicators of a single rank and messages to nobody do not count.
#include <mpi.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

enum Kind { Send, Allreduce, Reduce, Broadcast, Gather, Allgather, Alltoall, Scan, Barrier, kinds };
constexpr std::array<const char*, kinds> names{"send",      "allreduce", "reduce", "broadcast", "gather",
                                               "allgather", "alltoall",  "scan",   "barrier"};

std::array<double, 2 * kinds> counted{};  // calls, then bytes

void count(Kind kind, int length, MPI_Datatype type, MPI_Comm comm, int to = 0) {
  int ranks = 1, size = 0;
  PMPI_Comm_size(comm, &ranks);
  if (ranks == 1 || to == MPI_PROC_NULL) return;
  if (type != MPI_DATATYPE_NULL) PMPI_Type_size(type, &size);
  counted[kind] += 1;
  counted[kinds + kind] += static_cast<double>(length) * size;
}

void count_fortran(Kind kind, const int* length, const MPI_Fint* type, const MPI_Fint* comm, int to = 0) {
  count(kind, *length, type == nullptr ? MPI_DATATYPE_NULL : PMPI_Type_f2c(*type), PMPI_Comm_f2c(*comm), to);
}

void write() {
  int rank = 0, ranks = 1;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  PMPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::vector<double> all(counted.size() * static_cast<std::size_t>(ranks));
  PMPI_Gather(counted.data(), 2 * kinds, MPI_DOUBLE, all.data(), 2 * kinds, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  const char* path = std::getenv("MESSAGE_COUNTS");
  std::FILE* file = rank == 0 && path != nullptr ? std::fopen(path, "w") : nullptr;
  if (file == nullptr) return;
  for (std::size_t i = 0; i < counted.size(); ++i) {
    std::fprintf(file, "%s\"%s %s\": [", i == 0 ? "{" : ",\n ", names[i % kinds], i < kinds ? "calls" : "bytes");
    for (std::size_t r = 0; r < static_cast<std::size_t>(ranks); ++r)
      std::fprintf(file, "%s%.0f", r == 0 ? "" : ", ", all[r * counted.size() + i]);
    std::fprintf(file, "]");
  }
  std::fprintf(file, "}\n");
  std::fclose(file);
}

}  // namespace

extern "C" {

int MPI_Finalize() {
  write();
  return PMPI_Finalize();
}

#define IXOS_SEND(name)                                                                        \
  int MPI_##name(const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm) { \
    count(Send, n, type, comm, to);                                                            \
    return PMPI_##name(data, n, type, to, tag, comm);                                          \
  }
#define IXOS_ISEND(name)                                                                                             \
  int MPI_##name(const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* request) { \
    count(Send, n, type, comm, to);                                                                                  \
    return PMPI_##name(data, n, type, to, tag, comm, request);                                                       \
  }
IXOS_SEND(Send)
IXOS_SEND(Ssend)
IXOS_SEND(Rsend)
IXOS_ISEND(Isend)
IXOS_ISEND(Issend)
IXOS_ISEND(Irsend)

int MPI_Sendrecv(const void* data, int n, MPI_Datatype type, int to, int tag, void* into, int m, MPI_Datatype other,
                 int from, int received_tag, MPI_Comm comm, MPI_Status* status) {
  count(Send, n, type, comm, to);
  return PMPI_Sendrecv(data, n, type, to, tag, into, m, other, from, received_tag, comm, status);
}

int MPI_Allreduce(const void* data, void* into, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  count(Allreduce, n, type, comm);
  return PMPI_Allreduce(data, into, n, type, op, comm);
}
int MPI_Iallreduce(const void* data, void* into, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm, MPI_Request* r) {
  count(Allreduce, n, type, comm);
  return PMPI_Iallreduce(data, into, n, type, op, comm, r);
}
int MPI_Reduce(const void* data, void* into, int n, MPI_Datatype type, MPI_Op op, int root, MPI_Comm comm) {
  count(Reduce, n, type, comm);
  return PMPI_Reduce(data, into, n, type, op, root, comm);
}
int MPI_Reduce_scatter(const void* data, void* into, const int* n, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  count(Reduce, n[0], type, comm);
  return PMPI_Reduce_scatter(data, into, n, type, op, comm);
}
int MPI_Bcast(void* data, int n, MPI_Datatype type, int root, MPI_Comm comm) {
  count(Broadcast, n, type, comm);
  return PMPI_Bcast(data, n, type, root, comm);
}
int MPI_Gather(const void* data, int n, MPI_Datatype type, void* into, int m, MPI_Datatype other, int root,
               MPI_Comm comm) {
  count(Gather, n, type, comm);
  return PMPI_Gather(data, n, type, into, m, other, root, comm);
}
int MPI_Gatherv(const void* data, int n, MPI_Datatype type, void* into, const int* m, const int* at, MPI_Datatype other,
                int root, MPI_Comm comm) {
  count(Gather, n, type, comm);
  return PMPI_Gatherv(data, n, type, into, m, at, other, root, comm);
}
int MPI_Scatter(const void* data, int n, MPI_Datatype type, void* into, int m, MPI_Datatype other, int root,
                MPI_Comm comm) {
  count(Gather, m, other, comm);
  return PMPI_Scatter(data, n, type, into, m, other, root, comm);
}
int MPI_Scatterv(const void* data, const int* n, const int* at, MPI_Datatype type, void* into, int m,
                 MPI_Datatype other, int root, MPI_Comm comm) {
  count(Gather, m, other, comm);
  return PMPI_Scatterv(data, n, at, type, into, m, other, root, comm);
}
int MPI_Allgather(const void* data, int n, MPI_Datatype type, void* into, int m, MPI_Datatype other, MPI_Comm comm) {
  count(Allgather, m, other, comm);
  return PMPI_Allgather(data, n, type, into, m, other, comm);
}
int MPI_Allgatherv(const void* data, int n, MPI_Datatype type, void* into, const int* m, const int* at,
                   MPI_Datatype other, MPI_Comm comm) {
  count(Allgather, n, type, comm);
  return PMPI_Allgatherv(data, n, type, into, m, at, other, comm);
}
int MPI_Alltoall(const void* data, int n, MPI_Datatype type, void* into, int m, MPI_Datatype other, MPI_Comm comm) {
  count(Alltoall, n, type, comm);
  return PMPI_Alltoall(data, n, type, into, m, other, comm);
}
int MPI_Scan(const void* data, void* into, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  count(Scan, n, type, comm);
  return PMPI_Scan(data, into, n, type, op, comm);
}
int MPI_Barrier(MPI_Comm comm) {
  count(Barrier, 0, MPI_DATATYPE_NULL, comm);
  return PMPI_Barrier(comm);
}

// From Fortran: what MUMPS calls.
#define IXOS_FORTRAN_SEND(name, ...)                                               \
  void pmpi_##name##_(void*, int*, MPI_Fint*, int*, int*, MPI_Fint*, __VA_ARGS__); \
  void mpi_##name##_(void* data, int* n, MPI_Fint* type, int* to, int* tag, MPI_Fint* comm, __VA_ARGS__)
IXOS_FORTRAN_SEND(send, int* error) {
  count_fortran(Send, n, type, comm, *to);
  pmpi_send_(data, n, type, to, tag, comm, error);
}
IXOS_FORTRAN_SEND(ssend, int* error) {
  count_fortran(Send, n, type, comm, *to);
  pmpi_ssend_(data, n, type, to, tag, comm, error);
}
IXOS_FORTRAN_SEND(isend, MPI_Fint* request, int* error) {
  count_fortran(Send, n, type, comm, *to);
  pmpi_isend_(data, n, type, to, tag, comm, request, error);
}

void pmpi_allreduce_(void*, void*, int*, MPI_Fint*, MPI_Fint*, MPI_Fint*, int*);
void mpi_allreduce_(void* data, void* into, int* n, MPI_Fint* type, MPI_Fint* op, MPI_Fint* comm, int* error) {
  count_fortran(Allreduce, n, type, comm);
  pmpi_allreduce_(data, into, n, type, op, comm, error);
}
void pmpi_reduce_(void*, void*, int*, MPI_Fint*, MPI_Fint*, int*, MPI_Fint*, int*);
void mpi_reduce_(void* data, void* into, int* n, MPI_Fint* type, MPI_Fint* op, int* root, MPI_Fint* comm, int* error) {
  count_fortran(Reduce, n, type, comm);
  pmpi_reduce_(data, into, n, type, op, root, comm, error);
}
void pmpi_reduce_scatter_(void*, void*, int*, MPI_Fint*, MPI_Fint*, MPI_Fint*, int*);
void mpi_reduce_scatter_(void* data, void* into, int* n, MPI_Fint* type, MPI_Fint* op, MPI_Fint* comm, int* error) {
  count_fortran(Reduce, n, type, comm);
  pmpi_reduce_scatter_(data, into, n, type, op, comm, error);
}
void pmpi_bcast_(void*, int*, MPI_Fint*, int*, MPI_Fint*, int*);
void mpi_bcast_(void* data, int* n, MPI_Fint* type, int* root, MPI_Fint* comm, int* error) {
  count_fortran(Broadcast, n, type, comm);
  pmpi_bcast_(data, n, type, root, comm, error);
}
void pmpi_gather_(void*, int*, MPI_Fint*, void*, int*, MPI_Fint*, int*, MPI_Fint*, int*);
void mpi_gather_(void* data, int* n, MPI_Fint* type, void* into, int* m, MPI_Fint* other, int* root, MPI_Fint* comm,
                 int* error) {
  count_fortran(Gather, n, type, comm);
  pmpi_gather_(data, n, type, into, m, other, root, comm, error);
}
void pmpi_alltoall_(void*, int*, MPI_Fint*, void*, int*, MPI_Fint*, MPI_Fint*, int*);
void mpi_alltoall_(void* data, int* n, MPI_Fint* type, void* into, int* m, MPI_Fint* other, MPI_Fint* comm,
                   int* error) {
  count_fortran(Alltoall, n, type, comm);
  pmpi_alltoall_(data, n, type, into, m, other, comm, error);
}
void pmpi_barrier_(MPI_Fint*, int*);
void mpi_barrier_(MPI_Fint* comm, int* error) {
  const int none = 0;
  count_fortran(Barrier, &none, nullptr, comm);
  pmpi_barrier_(comm, error);
}

void pmpi_finalize_(int*);
void mpi_finalize_(int* error) {
  write();
  pmpi_finalize_(error);
}

}  // extern "C"
