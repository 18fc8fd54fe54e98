#include "io/guarded.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"

namespace ixos {
namespace {

constexpr int threw = 1;  // exit status of a child that is well all the same

/// Address space of this process [bytes].
std::uint64_t taken() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t pages = 0;
  file >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void limit(int what, std::uint64_t value) {
  rlimit bounds{};
  getrlimit(static_cast<__rlimit_resource_t>(what), &bounds);
  if (bounds.rlim_max != RLIM_INFINITY && bounds.rlim_max < value) value = bounds.rlim_max;
  bounds.rlim_cur = value;
  setrlimit(static_cast<__rlimit_resource_t>(what), &bounds);
}

[[noreturn]] void be_child(const std::function<void()>& function, std::uint64_t bytes, unsigned seconds) {
  for (int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU}) std::signal(signal, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_AS, taken() + bytes);
  limit(RLIMIT_CPU, seconds);
  try {
    function();
  } catch (...) {
    _exit(threw);
  }
  _exit(0);
}

}  // namespace

std::string trial(const std::function<void()>& function, std::uint64_t bytes, unsigned seconds) {
  const pid_t child = fork();
  if (child < 0) throw FileError(std::string("no process can be started: ") + std::strerror(errno));
  if (child == 0) be_child(function, bytes, seconds);
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw FileError(std::string("a process is lost: ") + std::strerror(errno));
  if (WIFEXITED(status) && (WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == threw)) return "";
  return WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL) ? "takes too long"
                                                                                             : "crashes";
}

void try_reading(const std::string& path, const std::function<void()>& function) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  const std::uint64_t length = code ? 0 : size;  // the function will say what it thinks of no file
  constexpr std::uint64_t mebibyte = 1U << 20U;
  const std::string end = trial(function, 256 * mebibyte + 300 * length, 20 + static_cast<unsigned>(length / mebibyte));
  if (!end.empty()) throw InputError(path + ": is damaged: reading it " + end);
}

}  // namespace ixos
