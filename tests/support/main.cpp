// Runs Google Test under MPI. Every rank runs every test; the process fails where any rank fails. testing::TempDir() is
// a folder of this run's own, the same on all ranks, and is removed at the end.
#include <gtest/gtest.h>
#include <mpi.h>

#include <Tpetra_Core.hpp>
#include <cstdlib>
#include <filesystem>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  Tpetra::ScopeGuard guard(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) {
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
  }
  char folder[] = "/tmp/ixos-test-XXXXXX";
  if (rank == 0 && mkdtemp(folder) == nullptr) MPI_Abort(MPI_COMM_WORLD, 1);
  MPI_Bcast(folder, sizeof folder, MPI_CHAR, 0, MPI_COMM_WORLD);
  setenv("TEST_TMPDIR", folder, 1);

  const int failed = RUN_ALL_TESTS();
  int any = 0;
  MPI_Allreduce(&failed, &any, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  if (any != 0 && failed == 0 && rank == 0) std::fprintf(stderr, "another rank failed\n");
  std::error_code code;
  if (rank == 0) std::filesystem::remove_all(folder, code);
  return any;
}
