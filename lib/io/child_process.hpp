/// A program that runs beside this one.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace ixos {

/// The end of a child process.
struct ChildOutcome {
  int exit_status = 0;  ///< 128 + signal if a signal ended it
  double cpu_seconds = 0;
};

/// A child process without a shell, one BLAS thread unless the environment says otherwise; its output goes to a file. A
/// child of a rank of mpirun is no rank of that job.
/// The child ends with its parent, however the parent ends.
class ChildProcess {
 public:
  /// Throws FileError if no process can be made.
  ChildProcess(const std::vector<std::string>& command, const std::string& log);
  ~ChildProcess();  ///< Kills a child that still runs.
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Returns whether the child has ended, and fills in the outcome then. Does not wait.
  bool ended(ChildOutcome& outcome);
  ChildOutcome wait();  ///< Waits for the end.
  void send(int signal) const;
  double age() const;                ///< wall-clock seconds since it was started
  double processor_seconds() const;  ///< so far; 0 if the child has ended

 private:
  bool ended(ChildOutcome& outcome, int options);

  pid_t pid_;
  std::chrono::steady_clock::time_point start_;
};

/// Returns the start of the last line of a log that is not empty; empty if the log cannot be read.
std::string last_line(const std::string& log);

}  // namespace ixos
