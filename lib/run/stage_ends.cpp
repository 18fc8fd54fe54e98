#include "run/stage_ends.hpp"

#include <cstddef>

namespace ixos {

void transfer(Record& record, std::vector<StageEnd>& ends) {
  if (record.loading() ? !record.has_section("stages") : ends.empty()) {
    ends.clear();
    return;
  }
  const Record::Section section(record, "stages");
  std::size_t count = ends.size();
  record.number("ended", count);
  ends.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Record::Section own(record, "stage " + std::to_string(k + 1));
    record.text("name", ends[k].name);
    record.number("end", ends[k].time);
    record.number("steps", ends[k].steps);
    record.text("reason", ends[k].reason);
    record.number("next begins", ends[k].begin);
  }
}

}  // namespace ixos
