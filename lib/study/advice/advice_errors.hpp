/// The errors to expect of settings, from runs that differ from a base in one direction.
#pragma once
#include <string>
#include <vector>

#include "study/advice/advice_point.hpp"
#include "study/common/sequence_error.hpp"

namespace ixos {

/// The reason of a part of which the runs tell nothing.
inline constexpr const char* not_examined = "not examined";

/// The error to expect of a point, relative to the exact value of each quantity.
struct AdviceEstimate {
  std::vector<double> errors;              ///< by quantity; infinite if unknown
  std::vector<std::vector<double>> parts;  ///< by quantity and direction
  std::size_t beyond = 0;                  ///< levels that the point is finer than the finest one tested, at most

  double largest() const;  ///< of the errors
  std::size_t worst_quantity() const;
  std::size_t worst_direction() const;  ///< of the worst quantity
};

/// Adds the errors of all directions. Each is measured with everything else at a base, which may be much coarser than
/// the point; the base's own branch leads in each direction, and other branches are compared with its limit.
/// Differences that were measured elsewhere count where the base has none. A branch that replaces the scene's model has
/// at least the error of its columns and of its law's strain measure: a number may agree by coincidence. Runs that
/// differ from the base in several directions measure the interaction of directions, which the sum leaves out.
/// interaction() returns that of the point's own run, or else the smallest one of the runs that are farther from the
/// base in every direction, or else the largest one of all.
class AdviceErrors {
 public:
  /// `is_error`: by quantity, whether it is an error itself, whose exact value is 0. `noise`: by quantity, the change
  /// that a perturbation of 1e-10 causes; it counts in every error.
  AdviceErrors(const AdviceDirections& directions, AdvicePoint base, const std::vector<AdviceSample>& samples,
               std::vector<bool> is_error, std::vector<double> noise);

  /// Returns infinite errors for a point whose run did not reach its end.
  AdviceEstimate estimate(const AdvicePoint& point) const;

  /// Returns the estimated exact value of a quantity.
  double exact(std::size_t quantity) const { return exact_[quantity]; }

  /// Returns how much a run at a point differs from the sum of the directions, relative to the exact value.
  double interaction(const AdvicePoint& point, std::size_t quantity) const;

  /// Returns what the sequence of a direction tells of a quantity, as "asymptotic, of order 2".
  std::string reason(std::size_t direction, std::size_t quantity) const;

  /// Returns the relative error of a place whose branch replaces the scene's model, by the comparison of columns and by
  /// measure_error(); infinite if no columns were compared, 0 for other branches.
  double model_error(std::size_t direction, const AdvicePlace& place, std::size_t quantity) const;

  /// Returns the error by the strain measure of a branch's law, see ixos::measure_error(), for the strains of the runs
  /// with the scene's own law; 0 for a branch without a law.
  double measure_error(std::size_t direction, std::size_t branch) const;

  /// Returns whether the runs tell what a direction adds to the error of a point. If not, its part is 0 because nothing
  /// finer was run.
  bool is_examined(const AdvicePoint& point, std::size_t direction, std::size_t quantity) const;

  /// Returns the errors to hope for if a direction is refined once more and the sequence turns out to be asymptotic.
  AdviceErrors hopeful(std::size_t direction) const;

  /// Returns the uncertainty of a quantity's limit in a direction, relative to the exact value.
  double limit_uncertainty(std::size_t direction, std::size_t quantity) const;

  /// Returns whether the base's own sequence in a direction has an order for all quantities that have one.
  bool has_order(std::size_t direction) const;

  /// Returns the number of good runs on a line, their levels, and the finest level among them.
  std::size_t tested(std::size_t direction, std::size_t branch) const;
  const std::vector<std::size_t>& levels(std::size_t direction, std::size_t branch) const;
  std::size_t finest(std::size_t direction, std::size_t branch) const;

  /// Returns the relative error of a quantity in the finest run on a line; infinite without one.
  double finest_error(std::size_t direction, std::size_t branch, std::size_t quantity) const;
  std::size_t quantities() const { return is_error_.size(); }

  /// Returns the good runs on a line, the coarsest first.
  const std::vector<SequencePoint>& points(std::size_t direction, std::size_t branch, std::size_t quantity) const {
    return lines_[direction][branch].points[quantity];
  }

  /// Returns the branch of the base in a direction.
  std::size_t own(std::size_t direction) const { return base_[direction].branch; }

 private:
  /// The runs of a branch, by quantity.
  struct Line {
    std::vector<std::size_t> levels;
    std::vector<std::vector<SequencePoint>> points;
    std::vector<SequenceErrors> errors;
  };
  /// A run off the lines: its differences from the sum of the directions, by quantity.
  struct Defect {
    AdvicePoint point;
    std::vector<double> relative;
  };
  Line line(std::size_t d, std::size_t b, const Line& own, const std::vector<AdviceSample>& samples) const;
  std::vector<double> at_base(std::size_t d, const AdvicePlace& place, const std::vector<AdviceSample>& samples) const;
  std::vector<double> from_elsewhere(std::size_t d, const AdvicePlace& place, const Line& own,
                                     const std::vector<AdviceSample>& samples) const;
  static double levels_between(std::size_t d, const AdvicePoint& a, const AdvicePoint& b);
  static double levels_of(const AdvicePlace& a, const AdvicePlace& b);
  void judge(std::size_t d, std::size_t q);
  void doubt_two_sizes(std::size_t d, std::size_t q, SequenceErrors& own) const;
  void share_limit(std::size_t d, std::size_t q, SequenceErrors& own) const;
  void judge_branch(std::size_t d, std::size_t b, std::size_t q);
  double part(std::size_t d, std::size_t q, const AdvicePlace& place) const;
  double with_model(std::size_t d, std::size_t q, const AdvicePlace& place, double error) const;
  double change_by_step(const AdvicePoint& point, std::size_t q) const;
  double scale(std::size_t q) const;
  void measure_interaction(const std::vector<AdviceSample>& samples);
  bool is_farther(const AdvicePoint& far, const AdvicePoint& near) const;

  const AdviceDirections& directions_;
  AdvicePoint base_;
  std::vector<bool> is_error_;
  std::vector<double> noise_, base_values_, exact_;
  std::vector<std::vector<Line>> lines_;
  std::vector<std::vector<bool>> examined_;  ///< by direction and quantity: the base's own branch
  std::vector<Defect> defects_;
  std::vector<AdvicePoint> failed_;  ///< points of runs that did not reach their end
  std::vector<AdviceSample> good_;   ///< the others
};

}  // namespace ixos
