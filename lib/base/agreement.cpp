#include "base/agreement.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <vector>

namespace ixos {
namespace {

std::string broadcast_text(const Comm& comm, int root, const std::string& text) {
  auto length = static_cast<int>(text.size());
  Teuchos::broadcast(*comm, root, &length);
  std::vector<char> letters(text.begin(), text.end());
  letters.resize(static_cast<std::size_t>(length));
  Teuchos::broadcast(*comm, root, length, letters.data());
  return {letters.begin(), letters.end()};
}

}  // namespace

std::string first_problem(const Comm& comm, const std::string& problem) {
  if (comm->getSize() == 1) return problem;
  const int mine = problem.empty() ? comm->getSize() : comm->getRank();
  int first = 0;
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_MIN, 1, &mine, &first);
  if (first == comm->getSize()) return {};
  return broadcast_text(comm, first, problem);
}

std::string from_first_rank(const Comm& comm, const std::string& text) {
  return comm->getSize() == 1 ? text : broadcast_text(comm, 0, text);
}

}  // namespace ixos
