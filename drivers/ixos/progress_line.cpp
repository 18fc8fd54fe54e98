#include "progress_line.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace ixos {

std::string duration(double seconds) {
  const long s = std::lround(seconds);
  if (s >= 3600) return fmt::format("{} h {:02} min", s / 3600, s % 3600 / 60);
  if (s >= 60) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} s", s);
}

std::string in_words(const Progress& p) {
  std::string text = fmt::format("t = {:.4g} of {:.4g} T0, step {}", p.time, p.final_time, p.step);
  if (p.within_step)
    text += fmt::format("; the next one, {:.3g} T0: Newton iteration {}, residual {:.1e} of {:.1e}", p.time_step,
                        p.newton.iteration, p.newton.residual, p.newton.bound);
  else if (p.step > 0)
    text += fmt::format(", {:.2f} Newton iterations a step",
                        static_cast<double>(p.newton_iterations) / static_cast<double>(p.step));
  return p.seconds_left > 0 ? text + ", " + duration(p.seconds_left) + " left" : text;
}

void ProgressLine::show(const Progress& p) {
  if (last_shown_ < 0) last_shown_ = p.wall_seconds;
  if (p.wall_seconds - last_shown_ < interval_) return;
  last_shown_ = p.wall_seconds;
  if (is_terminal_)
    fmt::print(stderr, "\r\033[K{}", in_words(p));
  else
    fmt::print(stderr, "{}\n", in_words(p));
  stands_ = is_terminal_;
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (stands_) fmt::print(stderr, "\r\033[K");
  stands_ = false;
}

}  // namespace ixos
