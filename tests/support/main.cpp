// Runs Google Test under MPI. Every rank runs every test; the process fails where any rank fails. testing::TempDir() is
// a folder of this run's own, the same on all ranks, and is removed at the end.
#include <gtest/gtest.h>
#include <mpi.h>

#include <Tpetra_Core.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace {

/// Says on which rank an expectation failed, and ends the job where a test was left: the other ranks would wait for
/// this one in a collective operation.
class RankPrinter final : public testing::EmptyTestEventListener {
 public:
  RankPrinter(int rank, int ranks) : rank_(rank), ranks_(ranks) {}

 private:
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    if (rank_ > 0)
      std::fprintf(stderr, "[rank %d] %s:%d\n%s\n", rank_, result.file_name() == nullptr ? "?" : result.file_name(),
                   result.line_number(), result.message());
    if (!result.fatally_failed() || ranks_ == 1) return;
    std::fflush(nullptr);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }

  int rank_, ranks_;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  Tpetra::ScopeGuard guard(&argc, &argv);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  auto& listeners = testing::UnitTest::GetInstance()->listeners();
  if (rank != 0) delete listeners.Release(listeners.default_result_printer());
  listeners.Append(new RankPrinter(rank, ranks));
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
