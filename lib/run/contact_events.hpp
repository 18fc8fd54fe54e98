/// When surfaces come into contact and leave it.
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "base/record.hpp"

namespace ixos {

/// Times of one interaction's contact [T0]; NaN: there was none. It is in contact in a row whose contact measure is
/// greater than 0: some point is nearer than the gap of largest attraction.
struct ContactTimes {
  std::string interaction;
  double first = std::numeric_limits<double>::quiet_NaN();     ///< the first row in contact
  double released = std::numeric_limits<double>::quiet_NaN();  ///< the row after the last one in contact
};

/// Gathers them over the recorded rows.
class ContactEvents {
 public:
  explicit ContactEvents(const std::vector<std::string>& interactions);

  /// Goes on with the times of other events; interactions that only those have come last, and take part no more.
  void go_on_from(const ContactEvents& before);
  /// Takes part in a row. `measures`: contact measures by interaction.
  void row(double time, const std::vector<double>& measures);
  const std::vector<ContactTimes>& times() const { return times_; }

  /// For checkpoints.
  void transfer(Record& record);

 private:
  void take(const ContactTimes& times, bool touches, bool new_ones_too);

  std::vector<ContactTimes> times_;
  std::vector<char> touches_;  ///< in the row before
};

}  // namespace ixos
