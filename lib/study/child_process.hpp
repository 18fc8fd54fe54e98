/// A program run beside this one.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace ixos {

/// How a child ended.
struct ChildOutcome {
  int exit_status = 0;  ///< 128 + signal where a signal ended it
  double cpu_seconds = 0;
};

/// A child process without a shell, one BLAS thread unless the environment says otherwise; its output goes to a file.
/// It dies with its parent, whatever becomes of that.
class ChildProcess {
 public:
  /// Throws FileError where no process can be made.
  ChildProcess(const std::vector<std::string>& command, const std::string& log);
  ~ChildProcess();  ///< Kills a child that still runs.
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Has it ended? Fills in the outcome then. Does not wait.
  bool ended(ChildOutcome& outcome);
  void send(int signal) const;
  double age() const;  ///< wall-clock seconds since it was started

 private:
  pid_t pid_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace ixos
