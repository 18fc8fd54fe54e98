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

void ProgressLine::show(const Progress& p) {
  if (last_shown_ < 0) first_time_ = p.time;
  if (last_shown_ >= 0 && p.wall_seconds - last_shown_ < 0.2 && p.time < p.final_time) return;
  last_shown_ = p.wall_seconds;
  const double done = (p.time - first_time_) / (p.final_time - first_time_);
  const double left = done > 0 ? p.wall_seconds * (1 - done) / done : 0;
  fmt::print(stderr, "\r\033[Kt = {:.4g} of {:.4g} T0, step {}, {:.2f} Newton iterations a step, {} left", p.time,
             p.final_time, p.step, static_cast<double>(p.newton_iterations) / static_cast<double>(p.step),
             duration(left));
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (last_shown_ >= 0) fmt::print(stderr, "\r\033[K");
}

}  // namespace ixos
