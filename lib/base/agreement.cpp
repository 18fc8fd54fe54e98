#include "base/agreement.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <vector>

#include "base/error.hpp"

namespace ixos {

void agree_on_files(const Comm& comm, const std::string& problem) {
  if (comm->getSize() == 1) {
    if (!problem.empty()) throw FileError(problem);
    return;
  }
  const int mine = problem.empty() ? comm->getSize() : comm->getRank();
  int first = 0;
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_MIN, 1, &mine, &first);
  if (first == comm->getSize()) return;
  int length = static_cast<int>(problem.size());
  Teuchos::broadcast(*comm, first, &length);
  std::vector<char> text(problem.begin(), problem.end());
  text.resize(static_cast<std::size_t>(length));
  Teuchos::broadcast(*comm, first, length, text.data());
  throw FileError(std::string(text.begin(), text.end()));
}

}  // namespace ixos
