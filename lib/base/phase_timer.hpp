/// Timers for the phases of a run.
#pragma once
#include <Teuchos_Time.hpp>
#include <array>
#include <string>

namespace ixos {

/// The timed phases. Their seconds add up over all objects of the process.
enum class Phase { Residual, Tangent, Factorization, LinearSolve, Output };
inline constexpr std::array<const char*, 5> phase_names{"residual", "tangent", "factorization", "linear solve",
                                                        "output"};

/// Returns the timer of a phase, registered with Teuchos::TimeMonitor as "Ixos: <name>".
Teuchos::Time& phase_timer(Phase phase);

/// Returns the name of the innermost phase that is being timed; null outside all phases.
const char* current_phase() noexcept;

/// A guard that times a scope. Inside another scope of the same phase it times nothing: the outer one counts this time.
class TimedScope {
 public:
  explicit TimedScope(Phase phase);
  ~TimedScope();
  TimedScope(const TimedScope&) = delete;
  TimedScope& operator=(const TimedScope&) = delete;

 private:
  Teuchos::Time& timer_;
  bool outermost_;  ///< of its phase
  const char* outer_;
};

/// Names what a scope does, for current_phase(); times nothing.
class NamedScope {
 public:
  explicit NamedScope(const char* name);
  ~NamedScope();
  NamedScope(const NamedScope&) = delete;
  NamedScope& operator=(const NamedScope&) = delete;

 private:
  const char* outer_;
};

using PhaseSeconds = std::array<double, phase_names.size()>;

/// Returns the seconds in each phase so far.
PhaseSeconds phase_seconds();

}  // namespace ixos
