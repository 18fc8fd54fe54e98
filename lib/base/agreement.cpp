#include "base/agreement.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <vector>

namespace ixos {

std::string first_problem(const Comm& comm, const std::string& problem) {
  if (comm->getSize() == 1) return problem;
  const int mine = problem.empty() ? comm->getSize() : comm->getRank();
  int first = 0;
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_MIN, 1, &mine, &first);
  if (first == comm->getSize()) return {};
  int length = static_cast<int>(problem.size());
  Teuchos::broadcast(*comm, first, &length);
  std::vector<char> text(problem.begin(), problem.end());
  text.resize(static_cast<std::size_t>(length));
  Teuchos::broadcast(*comm, first, length, text.data());
  return {text.begin(), text.end()};
}

}  // namespace ixos
