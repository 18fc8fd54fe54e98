// Runs Google Test under MPI. Every rank runs every test; the process fails where any rank fails.
#include <gtest/gtest.h>
#include <mpi.h>

#include <Tpetra_Core.hpp>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  Tpetra::ScopeGuard guard(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) {
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
  }
  const int failed = RUN_ALL_TESTS();
  int any = 0;
  MPI_Allreduce(&failed, &any, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  if (any != 0 && failed == 0 && rank == 0) std::fprintf(stderr, "another rank failed\n");
  return any;
}
