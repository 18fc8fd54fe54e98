#include "base/warning.hpp"

namespace ixos {

void transfer(Record& record, std::vector<Warning>& warnings) {
  auto count = warnings.size();
  record.number("warnings", count);
  std::vector<Warning> all;
  for (std::size_t k = 0; k < count; ++k) {
    Warning own = record.loading() ? Warning() : warnings[k];
    const Record::Section section(record, "warning " + std::to_string(k));
    record.text("name", own.name);
    record.text("message", own.message);
    all.push_back(std::move(own));
  }
  warnings = std::move(all);
}

}  // namespace ixos
