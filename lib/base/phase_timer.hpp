/// Where the time goes.
#pragma once
#include <Teuchos_Time.hpp>
#include <array>
#include <string>

namespace ixos {

/// The phases that are timed. Their seconds add up over all objects of the process.
enum class Phase { Residual, Tangent, Factorization, LinearSolve, Output };
inline constexpr std::array<const char*, 5> phase_names{"residual", "tangent", "factorization", "linear solve",
                                                        "output"};

/// The timer of a phase, registered with Teuchos::TimeMonitor as "Ixos: <name>".
Teuchos::Time& phase_timer(Phase phase);

/// The innermost phase that is being timed; null outside of all.
const char* current_phase() noexcept;

/// Times a scope.
class TimedScope {
 public:
  explicit TimedScope(Phase phase);
  ~TimedScope();
  TimedScope(const TimedScope&) = delete;
  TimedScope& operator=(const TimedScope&) = delete;

 private:
  Teuchos::Time& timer_;
  const char* outer_;
};

using PhaseSeconds = std::array<double, phase_names.size()>;

/// Returns the seconds in each phase so far.
PhaseSeconds phase_seconds();

}  // namespace ixos
