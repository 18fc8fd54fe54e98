/// A watch on the contact and the forces of recorded rows.
#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/record.hpp"

namespace ixos {

/// The largest fall of the contact between two rows.
struct Detachment {
  double before = 0, after = 0;  ///< contact measure of the rows [L0^(D-1)]
  double from = 0, to = 0;       ///< their times [T0]
};

/// How far a force is from smooth while the front of the contact passes single faces.
struct Ripple {
  std::string column;    ///< of the largest force
  double roughness = 0;  ///< root mean square of F_k - (F_k-1 + F_k+1)/2 over that of F_k [-]
  double faces = 0;      ///< that the front passed in these rows
};

class ContactWatch {
 public:
  /// `face`: the length of a face along which the front moves [L0]; 0: no ripple is looked for.
  explicit ContactWatch(double face = 0) : face_(face) {}

  /// Takes part in a row: contact measure (NaN if it is not recorded), and forces by column.
  void row(double time, double measure, const std::vector<std::pair<std::string, double>>& forces);

  double largest_measure() const { return largest_; }
  const Detachment& largest_fall() const { return fall_; }
  /// Returns the ripple over rows between whose neighbours the front has moved, by at most 4 faces.
  Ripple ripple() const;

  /// For checkpoints.
  void transfer(Record& record);

 private:
  struct Force {
    std::string column;
    std::array<double, 2> last{};  ///< of the two rows before, the later one first
    double rough = 0, size = 0;    ///< sums of squares
  };

  double face_;
  long rows_ = 0;
  double time_ = 0;                  ///< of the row before
  std::array<double, 2> measure_{};  ///< of the two rows before
  double largest_ = 0;
  double passed_ = 0;  ///< by the front, in rows that count [L0]
  Detachment fall_;
  std::vector<Force> forces_;
};

}  // namespace ixos
