#include "histories/catalogue.hpp"

namespace ixos {

#define ENTRY(name) HistoryEntry name();
#include "histories/entries.def"
#undef ENTRY

const Catalogue<HistoryEntry>& histories() {
#define ENTRY(name) name(),
  static const Catalogue<HistoryEntry> catalogue("Type", "Kind of function.",
                                                 {
#include "histories/entries.def"
                                                 });
#undef ENTRY
  return catalogue;
}

std::string history_value(const std::string& what) {
  return what + " [L0 for a motion, - for a load, rad for an angle]. A load is its Vector times this number.";
}

std::string history_jump(const std::string& what) {
  return what + ": after the Initial Time this drives loads, and motions of the scheme Static only.";
}

}  // namespace ixos
