#include "base/memory.hpp"

#include <fmt/format.h>

#include "base/phase_timer.hpp"

namespace ixos {
namespace {

// They belong to the process, as memory does. Noting a failure allocates nothing.
bool failed = false;
std::size_t failed_bytes = 0;
const char* failed_phase = nullptr;

std::string in_words(double bytes) {
  for (const char* unit : {"bytes", "KiB", "MiB"}) {
    if (bytes < 1024) return fmt::format("{:.4g} {}", bytes, unit);
    bytes /= 1024;
  }
  return fmt::format("{:.4g} GiB", bytes);
}

}  // namespace

void note_failed_allocation(std::size_t bytes) noexcept {
  failed = true;
  failed_bytes = bytes;
  failed_phase = current_phase();
}

bool memory_ran_out() noexcept { return failed; }

std::string out_of_memory() {
  std::string text = "out of memory";
  if (failed_bytes > 0) text += ": " + in_words(static_cast<double>(failed_bytes)) + " were asked for";
  if (failed_phase != nullptr) text += std::string(failed_bytes > 0 ? ", " : ": ") + "phase: " + failed_phase;
  return text;
}

}  // namespace ixos
