#include "study/compare/study_runner.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "study/common/results_folder.hpp"
#include "study/common/run_pool.hpp"
#include "study/compare/recommendation.hpp"

namespace ixos {
namespace {

class Runner {
 public:
  Runner(const Study& study, const RunnerOptions& options)
      : study_(study),
        options_(options),
        pool_({options.folder + "/runs", study.scene, options.driver, options.version, study.time_limit,
               options.interrupted}) {}

  StudyStatus run(std::vector<StudyResult>& results, ReferenceQuality& quality) {
    std::string reference = study_.reference_folder;
    if (reference.empty()) {
      StudyRun run{"reference", {}, study_.common};
      run.settings.insert(run.settings.end(), study_.reference.begin(), study_.reference.end());
      std::vector<StudyResult> found;
      if (!run_all({run}, 1, nullptr, found)) return StudyStatus::Interrupted;
      reference = pool_.folder(run);
      if (!found.front().reached_its_end()) {
        results = std::move(found);
        return StudyStatus::ReferenceFailed;
      }
    }
    StudyReference compared(reference, study_.errors);
    std::string unknown = study_.check.description;
    if (!study_.check.settings.empty() && !check(compared, unknown)) return StudyStatus::Interrupted;
    quality = compared.quality();
    if (quality.origin.empty() && quality.unknown.empty()) quality.unknown = unknown;
    return run_all(study_.runs, study_.jobs, &compared, results) ? StudyStatus::Done : StudyStatus::Interrupted;
  }

 private:
  /// Runs the check of the reference, and judges the reference by it, or says why not. Returns false if interrupted.
  bool check(StudyReference& compared, std::string& why_not) {
    StudyRun run{"reference-check", {}, study_.common};
    for (const Assignments* more : {&study_.reference, &study_.check.settings})
      run.settings.insert(run.settings.end(), more->begin(), more->end());
    std::vector<StudyResult> found;
    if (!run_all({run}, 1, nullptr, found)) return false;
    if (!found.front().reached_its_end()) {
      why_not = fmt::format("{} did not reach its end: {}", study_.check.description, found.front().reason);
      return true;
    }
    try {
      compared.judge(pool_.folder(run), study_.check.description);
    } catch (const InputError& error) {
      why_not = fmt::format("{} has {}", study_.check.description, error.what());
    }
    return true;
  }

  /// Carries out the runs. Returns false if interrupted. Results come in the order of the runs, without those that did
  /// not end.
  bool run_all(const std::vector<StudyRun>& runs, int jobs, const StudyReference* reference,
               std::vector<StudyResult>& results) {
    std::vector<std::optional<StudyResult>> found(runs.size());
    std::size_t done = 0;
    const bool complete = pool_.carry_out(runs, jobs, [&](std::size_t number, bool reused) {
      found[number] = result(runs[number], reference);
      ++done;
      if (options_.watch) options_.watch(*found[number], done, reused);
    });
    for (std::optional<StudyResult>& result : found)
      if (result) results.push_back(std::move(*result));
    return complete;
  }

  StudyResult result(const StudyRun& run, const StudyReference* reference) const {
    StudyResult result{pool_.record(run), {}};
    if (!result.reached_its_end() || reference == nullptr) return result;
    try {
      result.errors = reference->errors(pool_.folder(run));
    } catch (const InputError& error) {
      result.reason = error.what();  // a result without errors; the others have theirs
    }
    return result;
  }

  const Study& study_;
  const RunnerOptions& options_;
  RunPool pool_;
};

}  // namespace

StudyOutcome run_study(const Study& study, const RunnerOptions& options) {
  std::error_code code;
  std::filesystem::create_directories(options.folder, code);
  if (code) throw FileError("the results folder cannot be used: " + options.folder + ": " + code.message());
  const std::string scene = std::filesystem::absolute(study.scene).lexically_normal().string();
  const std::string owner = printable(fmt::format("the study \"{}\" of {}", study.name, scene));
  const ResultsFolder held(options.folder, owner, options.overwrite);
  StudyOutcome outcome;
  ReferenceQuality quality;
  outcome.status = Runner(study, options).run(outcome.results, quality);
  if (outcome.status != StudyStatus::Done) return outcome;
  write_study(study, outcome.results, quality, options.folder, options.command, options.version);
  outcome.recommendation = recommend(study, outcome.results, quality).sentence;
  return outcome;
}

}  // namespace ixos
