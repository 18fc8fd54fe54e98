#include "console.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace ixos::console {
namespace {

int failure = 0;  ///< the first error number

void note(bool good) {
  if (!good && failure == 0) failure = errno != 0 ? errno : EIO;
}

}  // namespace

void print(const std::string& text) {
  errno = 0;
  note(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

void flush() {
  errno = 0;
  note(std::fflush(stdout) == 0);
}

void print_error(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

std::string lost() {
  flush();
  return failure == 0 ? "" : std::string("standard output: cannot be written: ") + std::strerror(failure);
}

}  // namespace ixos::console
