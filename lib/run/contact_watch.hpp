/// A watch on the contact and the forces of recorded rows.
#pragma once
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "base/record.hpp"

namespace ixos {

/// A fall of the contact between two rows.
struct Detachment {
  double before = 0, after = 0;  ///< contact measure of the rows [L0^(D-1)]
  double from = 0, to = 0;       ///< their times [T0]
};

/// The part of a force that repeats itself whenever the front of the contact passes a face.
struct Ripple {
  std::string column;    ///< of the force
  double amplitude = 0;  ///< [E0 L0^(D-1)]
  double largest = 0;    ///< largest magnitude of the force
};

class ContactWatch {
 public:
  /// `face`: the length of a face along which the front moves [L0]; 0: no ripple is looked for.
  explicit ContactWatch(double face = 0) : face_(face) {}

  /// Takes part in a row: contact measure (NaN if it is not recorded), and forces by column.
  void row(double time, double measure, const std::vector<std::pair<std::string, double>>& forces);

  double largest_measure() const { return largest_; }
  /// Returns the largest fall between two rows.
  const Detachment& largest_fall() const { return fall_; }
  /// Returns the ripple of the largest force; no column unless the front has passed 8 faces in rows at most half a face
  /// apart. A force F = F0 + A cos(2 pi L/h) of the contact's length L has int e^(2 pi i L/h) dF = -i A pi L_all/h.
  Ripple ripple() const;

  /// For checkpoints.
  void transfer(Record& record);

 private:
  struct Force {
    std::string column;
    double last = 0, largest = 0;
    std::complex<double> sum = 0;  ///< of e^(2 pi i L/h) dF
  };

  double face_;
  double time_ = 0, measure_ = 0;  ///< of the row before
  bool any_ = false;               ///< there was one
  double largest_ = 0;
  double passed_ = 0;  ///< by the front, in rows that count [L0]
  Detachment fall_;
  std::vector<Force> forces_;
};

}  // namespace ixos
