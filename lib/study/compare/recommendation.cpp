#include "study/compare/recommendation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "study/common/tuning.hpp"

namespace ixos {
namespace {

/// A run, and the error that counts for it.
struct Candidate {
  const StudyResult* run;
  double cost, error;
  const StudyResult* worse = nullptr;  ///< a finer run of a larger error, which counts
};

/// Returns whether the labels are numbers, a unit aside, that rise or fall.
bool refines(const Axis& axis) {
  std::vector<double> numbers;
  for (const AxisValue& value : axis.values) {
    char* end = nullptr;
    numbers.push_back(std::strtod(value.label.c_str(), &end));
    if (end == value.label.c_str() || !std::isfinite(numbers.back())) return false;
  }
  const auto equal_or = [&](auto order) { return std::adjacent_find(numbers.begin(), numbers.end(), order); };
  return equal_or([](double a, double b) { return a >= b; }) == numbers.end() ||
         equal_or([](double a, double b) { return a <= b; }) == numbers.end();
}

/// Raises the errors along a line, which is in the order of the axis.
void raise_errors(std::vector<Candidate*> line) {
  if (line.front()->cost < line.back()->cost) std::reverse(line.begin(), line.end());  // the finest first
  const Candidate* worst = line.front();
  for (Candidate* candidate : line) {
    if (candidate->error >= worst->error) {
      worst = candidate;
    } else {
      candidate->error = worst->error;
      candidate->worse = worst->run;
    }
  }
}

/// Returns the runs that have an error, the cheapest first.
std::vector<Candidate> candidates(const Study& study, const std::vector<StudyResult>& results) {
  const Question& asked = study.question;
  std::vector<Candidate> all;
  for (const StudyResult& result : results)
    if (result.reached_its_end() && std::isfinite(result.error(asked.measure)))
      all.push_back({&result, result.cost(asked.cost), result.error(asked.measure)});
  const auto axis = std::find_if(study.axes.begin(), study.axes.end(),
                                 [&](const Axis& candidate) { return candidate.name == asked.connect; });
  if (axis != study.axes.end() && refines(*axis)) {
    const auto place = static_cast<std::size_t>(axis - study.axes.begin());
    std::map<std::vector<std::string>, std::vector<Candidate*>> lines;
    for (const AxisValue& value : axis->values)
      for (Candidate& candidate : all) {
        std::vector<std::string> labels = candidate.run->run.labels;
        if (labels[place] != value.label) continue;
        labels.erase(labels.begin() + static_cast<std::ptrdiff_t>(place));
        lines[labels].push_back(&candidate);
      }
    for (auto& [labels, line] : lines) raise_errors(line);
  }
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
    return std::pair(a.cost, a.error) < std::pair(b.cost, b.error);
  });
  return all;
}

/// Returns a run's labels as "Scheme Newmark, Time Step 0.001".
std::string described(const Study& study, const StudyRun& run) {
  std::string text;
  for (std::size_t i = 0; i < study.axes.size(); ++i)
    text += (i > 0 ? ", " : "") + study.axes[i].name + " " + run.labels[i];
  return text;
}

std::string cost_text(const std::string& cost, double value) {
  if (cost == "newton_iterations") return fmt::format("{:.0f} Newton iterations", value);
  return fmt::format("{:.3g} s {}", value, cost == "cpu_seconds" ? "of processor time" : "of wall-clock time");
}

/// The question, the reference's own error, and the sentences that tell of both.
class Answer {
 public:
  Answer(const Study& study, const ReferenceQuality& reference)
      : study_(study), asked_(study.question), reference_(reference), measure_(measure(asked_.measure)) {
    const double own = reference.own.*measure_.error;
    if (std::isfinite(own)) own_ = own;
  }

  bool within(const Candidate& candidate) const { return candidate.error + own_.value_or(0) <= asked_.tolerance; }

  /// Returns whether the run's own error alone would have it within the tolerance.
  bool by_coincidence(const Candidate& candidate) const {
    return candidate.worse != nullptr && !within(candidate) &&
           candidate.run->error(asked_.measure) + own_.value_or(0) <= asked_.tolerance;
  }

  std::string error() const { return fmt::format("error of the {}", measure_.quantity); }

  std::string told(const Candidate& candidate) const {
    std::string text = fmt::format("{} has a relative {} of {:.3g}", described(study_, candidate.run->run), error(),
                                   candidate.run->error(asked_.measure));
    if (own_) text += fmt::format(" +- {:.2g}", *own_);
    if (candidate.worse != nullptr)
      text += fmt::format(" (but {:.3g} with the finer {})", candidate.error, connected(*candidate.worse));
    return text + " for " + cost_text(asked_.cost, candidate.cost);
  }

  std::string coincidence(const Candidate& candidate) const {
    return fmt::format(" {} is not recommended: its error of {:.3g} is a coincidence, because the finer {} has {:.3g}.",
                       described(study_, candidate.run->run), candidate.run->error(asked_.measure),
                       connected(*candidate.worse), candidate.error);
  }

  /// Returns a doubt if the measure compares one number and the run's force over time is not within the tolerance.
  std::string doubt(const Candidate& candidate) const {
    const bool one_number = asked_.measure == "peak_error" || asked_.measure == "work_error";
    const double force = candidate.run->errors.force;
    if (!one_number || !(force > asked_.tolerance)) return "";
    return fmt::format(
        " Its {} may agree by coincidence: its force over time differs by {:.3g} of the reference's, more than the "
        "tolerance.",
        measure_.quantity, force);
  }

  /// Returns what is known of the reference as far as it matters for the measure.
  std::string reference() const {
    if (!own_) {
      const bool matters = asked_.measure != "error_energy" && !reference_.unknown.empty();
      return matters ? fmt::format(" The reference's own error is unknown: {}.", reference_.unknown) : "";
    }
    std::string text =
        fmt::format(" The reference's own {} is about {:.2g} (from {}).", error(), *own_, reference_.origin);
    if (asked_.tolerance > 0 && *own_ > tuning::allowed_part * asked_.tolerance)
      text += fmt::format(
          " That is more than a third of the tolerance {:.3g}: the reference is too coarse for it; refine "
          "Reference/Settings.",
          asked_.tolerance);
    const Assignments& check = study_.check.settings;
    const auto is_of_mesh = [](const std::string& setting) { return setting.rfind("Mesh/", 0) == 0; };
    if (std::none_of(check.begin(), check.end(), is_of_mesh))
      text += " The error of its mesh was not examined (Reference/Check Settings).";
    return text;
  }

 private:
  std::string connected(const StudyResult& result) const {
    for (std::size_t i = 0; i < study_.axes.size(); ++i)
      if (study_.axes[i].name == asked_.connect) return asked_.connect + " " + result.run.labels[i];
    return result.run.name;
  }

  const Study& study_;
  const Question& asked_;
  const ReferenceQuality& reference_;
  const Measure& measure_;
  std::optional<double> own_;
};

/// Returns the most accurate run within a cost, the cheapest of equal ones; null if there is none.
const Candidate* most_accurate(const std::vector<Candidate>& all, double most) {
  const Candidate* best = nullptr;
  for (const Candidate& candidate : all)
    if (candidate.cost <= most && (best == nullptr || candidate.error < best->error)) best = &candidate;
  return best;
}

}  // namespace

std::vector<const StudyResult*> pareto(const std::vector<StudyResult>& results, const std::string& cost,
                                       const std::string& measure) {
  std::vector<const StudyResult*> sound, best;
  for (const StudyResult& result : results)
    if (result.reached_its_end() && std::isfinite(result.error(measure))) sound.push_back(&result);
  std::sort(sound.begin(), sound.end(), [&](const StudyResult* a, const StudyResult* b) {
    return std::pair(a->cost(cost), a->error(measure)) < std::pair(b->cost(cost), b->error(measure));
  });
  for (const StudyResult* result : sound)
    if (best.empty() || result->error(measure) < best.back()->error(measure)) best.push_back(result);
  return best;
}

Recommendation recommend(const Study& study, const std::vector<StudyResult>& results,
                         const ReferenceQuality& reference) {
  const Question& asked = study.question;
  const Answer words(study, reference);
  const std::vector<Candidate> all = candidates(study, results);
  Recommendation answer;
  if (all.empty()) {
    answer.sentence = "No run that reached its end has a known " + words.error() + ".";
    const auto note = reference.notes.find(asked.measure);
    if (note != reference.notes.end()) answer.sentence += " " + note->second;
    return answer;
  }
  if (asked.tolerance > 0) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Candidate& c) { return words.within(c); });
    if (found != all.end()) {
      answer.run = found->run;
      answer.sentence =
          fmt::format("The cheapest run within the tolerance {:.3g}: {}.", asked.tolerance, words.told(*found)) +
          words.doubt(*found);
    } else {
      answer.sentence = fmt::format("No run is within the tolerance {:.3g}. The most accurate run: {}.",
                                    asked.tolerance, words.told(*most_accurate(all, HUGE_VAL)));
    }
    const auto lucky = std::find_if(all.begin(), found, [&](const Candidate& c) { return words.by_coincidence(c); });
    if (lucky != found) answer.sentence += words.coincidence(*lucky);
  }
  if (asked.budget > 0) {
    const Candidate* affordable = most_accurate(all, asked.budget);
    const std::string budget = cost_text(asked.cost, asked.budget);
    answer.sentence += answer.sentence.empty() ? "" : " ";
    answer.sentence += affordable == nullptr
                           ? "No run costs at most " + budget + "."
                           : fmt::format("The most accurate run for at most {}: {}.", budget, words.told(*affordable));
    if (asked.tolerance == 0 && affordable != nullptr) answer.run = affordable->run;
  }
  answer.sentence += words.reference();
  return answer;
}

}  // namespace ixos
