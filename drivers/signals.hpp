/// Signals that ask a program to end.
#pragma once
#include <csignal>

namespace ixos {

inline volatile std::sig_atomic_t signal_flag = 0;

/// Returns whether a signal that was caught has asked the program to end.
inline bool signalled() { return signal_flag != 0; }

/// Catches SIGINT, SIGTERM and SIGHUP from here on. A SIGHUP that nohup ignores stays ignored.
inline void catch_signals() {
  const auto note = [](int) { signal_flag = 1; };
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, note);
  if (std::signal(SIGHUP, note) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

}  // namespace ixos
