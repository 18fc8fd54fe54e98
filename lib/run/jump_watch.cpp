#include "run/jump_watch.hpp"

#include <cmath>

namespace ixos {

Jump JumpWatch::row(double time, double balance, double external_work, double largest_energy) {
  constexpr double least_share = 1e-3;
  Jump found;
  const double released = balance_ - balance;
  const bool falls = balance + external_work < balance_ + work_;
  if (falls && released > 0.5 * std::abs(external_work - work_) && released > least_share * largest_energy) {
    found = {released, time_, time};
    ++jumps_.count;
    jumps_.released += released;
    if (released > jumps_.largest.released) jumps_.largest = found;
  }
  time_ = time;
  balance_ = balance;
  work_ = external_work;
  return found;
}

void JumpWatch::transfer(Record& record) {
  const Record::Section section(record, "jump watch");
  record.number("time", time_);
  bool known = !std::isnan(balance_);
  record.number("known", known);
  double balance = known ? balance_ : 0;
  record.number("balance", balance);
  balance_ = known && (!record.loading() || record.same_scene()) ? balance : none;  // others have other energies
  record.number("work", work_);
  record.number("released", jumps_.largest.released);
  record.number("from", jumps_.largest.from);
  record.number("to", jumps_.largest.to);
  if (record.loading() && !record.has_section("all")) {  // 0.2.0 knew the largest alone
    jumps_.count = jumps_.largest.released > 0 ? 1 : 0;
    jumps_.released = jumps_.largest.released;
    return;
  }
  const Record::Section all(record, "all");
  record.number("count", jumps_.count);
  record.number("released", jumps_.released);
}

}  // namespace ixos
