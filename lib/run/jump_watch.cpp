#include "run/jump_watch.hpp"

#include <cmath>

namespace ixos {

void JumpWatch::row(double time, double balance, double external_work) {
  const double released = balance_ - balance;
  const bool falls = balance + external_work < balance_ + work_;
  if (falls && released > largest_.released && released > 0.5 * std::abs(external_work - work_))
    largest_ = {released, time_, time};
  time_ = time;
  balance_ = balance;
  work_ = external_work;
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
  record.number("released", largest_.released);
  record.number("from", largest_.from);
  record.number("to", largest_.to);
}

}  // namespace ixos
