/// Advice on the settings of a scene: the cheapest ones that keep a tolerance.
#pragma once
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "study/advice/advice_plan.hpp"
#include "study/advice/sensitivity.hpp"
#include "study/common/asked_quantity.hpp"

namespace ixos {

struct AdviceQuestion {
  std::string scene;   ///< path of the scene's file
  Assignments common;  ///< changes of the scene that hold for all runs
  std::vector<AskedQuantity> quantities;
  double tolerance = 0.01;  ///< relative error of each quantity
  double budget = 0;        ///< seconds of processor time; 0: eight times the expected cost of the scene as it is
  bool verify = false;      ///< whether to compare the recommended settings with finer ones
};

struct AdviceOptions {
  std::string folder;  ///< results go here: runs/<name>/ for each run. Created if missing
  std::string driver;  ///< path of the program ixos
  std::string version;
  int jobs = 1;                                 ///< runs at a time
  bool overwrite = false;                       ///< replaces the results of another advice or study
  std::function<void(const std::string&)> log;  ///< called with one line for the budget and for each run; may be empty
  std::function<bool()> interrupted;            ///< called between polls; may be empty
};

/// Two dimensions in place of three.
struct AdvicePlane {
  AdviceQuestion question;             ///< on the scene in two dimensions
  std::vector<double> factors;         ///< by quantity: that of the whole depth over that of a unit
  std::vector<double> column_factors;  ///< the same of its column
  double depth = 1;                    ///< [L0]
  /// Largest relative one of the quantities and their columns in two and in three dimensions; infinite if it is not
  /// known.
  double difference = std::numeric_limits<double>::infinity();
};

/// Another choice in one direction, and the error that it causes.
struct AdviceChoice {
  std::string direction, label;
  std::vector<double> errors;  ///< by quantity, relative: of this direction alone
  double seconds = 0;          ///< of the recommended settings with this choice, to expect
};

/// A run that is finer than the recommended one.
struct AdviceVerification {
  bool step = false, mesh = false;  ///< whether each is finer
  /// Largest relative change of a quantity; negative if it is not known.
  double change = -1;
  std::string problem;  ///< why not, if it was asked for; a part of a sentence
};

/// Chaotic: a quantity depends on perturbations of 1e-10. Unreachable: no settings keep the tolerance that the budget
/// could find. NoRun: no run has the quantities.
enum class AdviceStatus { Advised, Chaotic, Unreachable, NoRun, Interrupted };

struct Advice {
  AdviceStatus status = AdviceStatus::Interrupted;
  AdviceDirections directions;
  std::vector<AdviceSample> samples;
  std::vector<double> sample_errors;       ///< by sample: the largest error of the quantities; infinite if unknown
  std::vector<AdviceChoice> choices;       ///< that were tried beside the recommended ones
  std::vector<Sensitivity> sensitivities;  ///< by quantity; empty if they were not measured
  std::vector<double> exact;               ///< by quantity: its estimated exact value
  std::vector<std::vector<std::string>> reasons;  ///< by direction and quantity: how the errors are known
  /// By direction and quantity: whether the runs tell the error, see AdviceErrors::is_examined().
  std::vector<std::vector<bool>> examined;
  /// The recommended settings; if there are none, those of the smallest error, or without a point if none is known.
  AdviceCandidate best;
  bool confirmed = false;               ///< whether the recommended settings were run
  std::string fails_later;              ///< why that run failed after the times that decide the quantities; empty: not
  double interaction = 0;               ///< the largest difference of runs from the sum of the directions, relative
  std::vector<AdviceCandidate> trades;  ///< of tested settings: none is better in both cost and error
  /// By tolerance, from ten times the asked one to a tenth: the cheapest settings to expect; without a point if none.
  std::vector<std::pair<double, AdviceCandidate>> other_tolerances;
  /// Two dimensions, if they answer a scene in space. Settings and quantities are those of its question.
  std::optional<AdvicePlane> plane;
  AdviceVerification verification;
  double budget = 0, spent = 0;  ///< seconds of processor time
  double sufficient_budget = 0;  ///< that may do where the budget did not; 0: not known
  std::string problem;           ///< why there is no recommendation; a sentence
};

/// Runs the scene with coarse settings first, estimates the errors of time step and mesh from the sequences of runs,
/// then tries other schemes, elements and models as long as their runs cost little beside what they may save. A scene
/// in space that is plane is answered in two dimensions. A run is done when its record stands in its folder; the same
/// advice reuses it. Throws InputError for a scene or quantity that is no good, and FileError.
Advice advise(const AdviceQuestion& question, const AdviceOptions& options);

}  // namespace ixos
