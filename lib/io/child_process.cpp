#include "io/child_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "io/disk_file.hpp"

namespace ixos {
namespace {

/// Returns this process's environment without what mpirun tells its own ranks: the child starts its own MPI.
std::vector<char*> environment() {
  std::vector<char*> result;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string text = *variable;
    const auto begins = [&text](const char* prefix) { return text.rfind(prefix, 0) == 0; };
    if (!begins("PMIX_") && !begins("PMI_") && !begins("OMPI_COMM_WORLD_") && !begins("OMPI_UNIVERSE_SIZE=") &&
        !begins("OMPI_MCA_orte_") && !begins("OMPI_MCA_ess"))
      result.push_back(*variable);
  }
  result.push_back(nullptr);
  return result;
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, const std::string& log)
    : pid_(-1), start_(std::chrono::steady_clock::now()) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  remove_link(log);
  const int output = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (output < 0) throw FileError(log + ": cannot be written: " + std::strerror(errno));
  setenv("OPENBLAS_NUM_THREADS", "1", 0);
  std::signal(SIGCHLD, SIG_DFL);  // a parent may have had it ignored, and children would leave no trace
  const std::vector<char*> variables = environment();
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    execve(arguments[0], arguments.data(), variables.data());
    _exit(127);
  }
  close(output);
  if (pid_ < 0) throw FileError(command[0] + ": cannot be started: " + std::strerror(errno));
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept : pid_(std::exchange(other.pid_, -1)), start_(other.start_) {}

ChildProcess::~ChildProcess() {
  if (pid_ < 0) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

bool ChildProcess::ended(ChildOutcome& outcome) { return ended(outcome, WNOHANG); }

ChildOutcome ChildProcess::wait() {
  ChildOutcome outcome;
  while (!ended(outcome, 0)) {  // a signal came
  }
  return outcome;
}

bool ChildProcess::ended(ChildOutcome& outcome, int options) {
  int status = 0;
  rusage usage{};
  const pid_t found = wait4(pid_, &status, options, &usage);
  if (found < 0 && errno != EINTR) throw std::runtime_error("a child process is lost");
  if (found != pid_) return false;
  pid_ = -1;
  outcome.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  outcome.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  return true;
}

void ChildProcess::send(int signal) const {
  if (pid_ > 0) kill(pid_, signal);
}

double ChildProcess::age() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double ChildProcess::processor_seconds() const {
  std::ifstream file("/proc/" + std::to_string(pid_) + "/stat");
  std::string text;
  std::getline(file, text);
  // The name in parentheses may hold spaces; the 12th and 13th fields after it are the user's and the system's ticks.
  std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  double user = 0, system = 0;
  return fields >> user >> system ? (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK)) : 0;
}

std::string last_line(const std::string& log) {
  std::ifstream file = open_text(log);
  std::string last;
  for (std::string line; std::getline(file, line);)
    if (!line.empty()) last = line;
  return last.substr(0, 400);
}

}  // namespace ixos
