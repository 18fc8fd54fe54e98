#include "io/guarded.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>

#include "base/error.hpp"
#include "io/persistent.hpp"

namespace ixos {
namespace {

constexpr std::size_t longest_message = 4000;  // what a pipe holds at once

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

void say(int pipe, const char* message) {
  if (write(pipe, message, std::min(std::strlen(message), longest_message)) < 0) _exit(1);
}

/// Calls the function in the child process. Writes the message of an exception to the pipe.
[[noreturn]] void be_child(const std::function<void()>& function, std::uint64_t bytes, unsigned seconds, int pipe) {
  for (int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGALRM}) std::signal(signal, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_AS, taken() + bytes);
  if (seconds > 0) {
    limit(RLIMIT_CPU, seconds);
    alarm(3 * seconds);  // for what waits
  }
  try {
    function();
  } catch (const std::bad_alloc&) {
    say(pipe, "reading it takes too much memory");
  } catch (const std::exception& error) {
    say(pipe, error.what());
  }
  _exit(0);
}

}  // namespace

std::string trial(const std::function<void()>& function, std::uint64_t bytes, unsigned seconds) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw FileError(std::string("no pipe can be made: ") + std::strerror(errno));
  const pid_t child = fork();
  if (child == 0) be_child(function, bytes, seconds, ends[1]);
  close(ends[1]);
  std::array<char, longest_message> message{};
  const ssize_t length = child < 0 ? 0 : persistent([&] { return read(ends[0], message.data(), message.size()); });
  close(ends[0]);
  int status = 0;
  if (child < 0 || persistent([&] { return waitpid(child, &status, 0); }) < 0)
    throw FileError(std::string("no process can be started: ") + std::strerror(errno));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
    return {message.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0))};
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  const bool late = signal == SIGXCPU || signal == SIGKILL || signal == SIGALRM;
  return late ? "reading it takes too long" : "reading it crashes";
}

void try_reading(const std::string& path, const std::function<void()>& function) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  const std::uint64_t length = code ? 0 : size;  // the function will say what it thinks of no file
  constexpr std::uint64_t mebibyte = 1U << 20U;
  const std::string end = trial(function, 256 * mebibyte + 300 * length, 20 + static_cast<unsigned>(length / mebibyte));
  if (!end.empty()) throw InputError(end.rfind(path, 0) == 0 ? end : path + ": is damaged: " + end);
}

void write_apart(const std::string& path, std::uint64_t room, const std::function<void()>& function) {
  constexpr std::uint64_t gibibyte = 1U << 30U;
  const std::string end = trial(function, gibibyte + 100 * room, 0);
  const std::string trouble = "reading it ";
  if (end.rfind(trouble, 0) == 0)
    throw FileError(path + ": cannot be written: the library " + end.substr(trouble.size()));
  if (!end.empty()) throw FileError(end.rfind(path, 0) == 0 ? end : path + ": cannot be written: " + end);
}

}  // namespace ixos
