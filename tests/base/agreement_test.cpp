#include "base/agreement.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "support/scene_text.hpp"

namespace ixos {
namespace {

/// A text of this rank alone; its length differs from those of its neighbours.
std::string text_of(int rank) {
  return "line 1\n\"line 2\" of rank " + std::to_string(rank) +
         std::string(static_cast<std::size_t>(5 * rank % 7), '.');
}

/// Returns what together() throws on this rank, its kind before its message; "nothing" if it returns.
template <class Error = FileError, class Function>
std::string thrown(const Comm& comm, const Function& function) {
  try {
    together<Error>(comm, function);
  } catch (const InputError& error) {
    return std::string("input: ") + error.what();
  } catch (const FileError& error) {
    return std::string("file: ") + error.what();
  } catch (const std::logic_error& error) {
    return std::string("defect: ") + error.what();
  }
  return "nothing";
}

TEST(AgreementTest, TheFirstProblemIsThatOfTheFirstRankThatHasOne) {
  const Comm comm = test::world();
  const int rank = comm->getRank(), ranks = comm->getSize();
  for (int first = 0; first <= ranks; ++first) {
    const std::string expected = first < ranks ? text_of(first) : "";
    EXPECT_EQ(first_problem(comm, rank >= first ? text_of(rank) : ""), expected);
    EXPECT_EQ(first_problem(comm, rank == first ? text_of(rank) : ""), expected);
  }
}

TEST(AgreementTest, AllRanksGetTheTextOfTheFirst) {
  const Comm comm = test::world();
  EXPECT_EQ(from_first_rank(comm, text_of(comm->getRank())), text_of(0));
  EXPECT_EQ(from_first_rank(comm, comm->getRank() == 0 ? "" : "not asked for"), "");
  const std::string zeros(3, '\0');
  EXPECT_EQ(from_first_rank(comm, comm->getRank() == 0 ? zeros : ""), zeros);
}

TEST(AgreementTest, TogetherCallsTheFunctionOnceOnEachRank) {
  int calls = 0;
  EXPECT_EQ(thrown(test::world(), [&calls] { ++calls; }), "nothing");
  EXPECT_EQ(calls, 1);
}

TEST(AgreementTest, AllRanksThrowTheErrorOfTheFirstRankThatFailed) {
  const Comm comm = test::world();
  const int rank = comm->getRank(), ranks = comm->getSize();
  const char* const kinds[] = {"input: ", "file: ", "defect: "};
  for (int shift = 0; shift < 3; ++shift)
    for (int first = 0; first <= ranks; ++first) {
      // Ranks that follow each other throw errors of different kinds.
      const auto fail = [&] {
        if (rank < first) return;
        if ((rank + shift) % 3 == 0) throw InputError(text_of(rank));
        if ((rank + shift) % 3 == 1) throw FileError(text_of(rank));
        throw std::out_of_range(text_of(rank));
      };
      EXPECT_EQ(thrown<std::logic_error>(comm, fail),
                first < ranks ? kinds[(first + shift) % 3] + text_of(first) : "nothing");
    }
}

TEST(AgreementTest, OtherErrorsAreFileErrorsByDefault) {
  const Comm comm = test::world();
  const bool last = comm->getRank() == comm->getSize() - 1;
  const auto fail = [last] {
    if (last) throw std::out_of_range("no such entry");
  };
  EXPECT_EQ(thrown(comm, fail), "file: no such entry");
}

TEST(AgreementTest, AnErrorWithoutAMessageIsAFailureAllTheSame) {
  EXPECT_EQ(thrown(test::world(), [] { throw InputError(""); }), "input: unknown failure");
}

// The other ranks would wait: this communicator has none.
TEST(AgreementTest, ALackOfMemoryPassesThrough) {
  EXPECT_THROW(together(test::self(), [] { throw std::bad_alloc(); }), std::bad_alloc);
  EXPECT_THROW(together(test::self(), [] { throw MemoryError("full"); }), MemoryError);
}

TEST(AgreementTest, OnFirstRankCallsTheFunctionThereOnly) {
  const Comm comm = test::world();
  int calls = 0;
  on_first_rank(comm, [&calls] { ++calls; });
  EXPECT_EQ(calls, comm->getRank() == 0 ? 1 : 0);
}

TEST(AgreementTest, AFailureOnTheFirstRankIsThrownOnAll) {
  const Comm comm = test::world();
  EXPECT_THROW(on_first_rank(comm, [] { throw InputError("bad"); }), InputError);
  EXPECT_THROW(on_first_rank(comm, [] { throw std::out_of_range("bad"); }), FileError);
}

}  // namespace
}  // namespace ixos
