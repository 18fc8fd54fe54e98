// ixos-study: runs a scene with many settings and says what accuracy costs. Exit status: 0 done; 1 a defect of ours;
// 2 bad input; 3 the reference failed, or there is no advice; 4 input or output failed; 5 interrupted.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/printable.hpp"
#include "completion.hpp"
#include "console.hpp"
#include "help.hpp"
#include "io/child_process.hpp"
#include "io/drawing.hpp"
#include "ixos-study/advise.hpp"
#include "ixos-study/jobs.hpp"
#include "ixos-study/scan.hpp"
#include "parameters/assignments.hpp"
#include "scene/explain/documentation.hpp"
#include "scene/read/parameters.hpp"
#include "shell_word.hpp"
#include "signals.hpp"
#include "study/compare/study.hpp"
#include "study/compare/study_result.hpp"
#include "study/compare/study_runner.hpp"

namespace {

struct Arguments {
  std::string study;
  ixos::AdviceArguments advice;  ///< with --set and --jobs, which a scan has, too
  ixos::ScanArguments scan;
  std::string output;
  bool overwrite = false;
  bool list = false;
  bool parameters = false;
  bool completion = false;
  bool version = false;
  bool quiet = false;
};

const char* const examples =
    "  ixos-study xml/ball-study.xml              run the study; results go to ball-study.results\n"
    "  ixos-study xml/ball-study.xml --list       list its runs, but do not run them\n"
    "  ixos-study --parameters                    list the parameters of a study\n"
    "  ixos-study --scan xml/pillar.xml --vary \"Materials/Polymer/Young's Modulus=0.5:2:4:log\" --collect \"peak "
    "reaction_top_y\"  run each value\n"
    "  ixos-study --advise xml/strip.xml --quantity \"peak reaction_right_y\" --tolerance 1%  recommend settings\n";

/// A picture or a report that a script makes of a results folder.
struct Product {
  const char* script;
  const char* data;
  const char* name;
  const char* file;
};
constexpr Product study_report{"study.py", "study.csv", "Plots and report", "report.html"};
constexpr Product advice_report{"advice.py", "advice.json", "Plots and report", "report.html"};
constexpr Product scan_picture{"scan.py", "scan.csv", "Picture of scan.csv", "scan.png"};

const char* const remark =
    "To resume an interrupted study or advice, run the same command again; finished runs are not repeated.\n";

std::string how_to_begin() {
  return std::string(
             "ixos-study runs a scene with many settings and compares their accuracy and cost. Give it a "
             "study:\n") +
         examples + "  ixos-study --help                          list all options\n" + remark;
}

std::filesystem::path own_folder() { return std::filesystem::read_symlink("/proc/self/exe").parent_path(); }

/// Returns a script that draws plots and writes a report. It is in the folder of the script that the link ixos-plot
/// beside this program points to.
std::string report_script(const char* name) {
  return (std::filesystem::weakly_canonical(own_folder() / "ixos-plot").parent_path() / name).string();
}

void print_run(const ixos::StudyResult& result, std::size_t done, std::size_t total, const std::string& measure,
               bool reused) {
  std::string what = result.status;
  if (!result.reason.empty()) what += ": " + result.reason;
  if (!result.run.labels.empty() && std::isfinite(result.error(measure)))
    what += fmt::format(", {} {:.3g}", measure, result.error(measure));
  ixos::console::say("[{}/{}] {}: {}, {:.3g} s{}\n", done, total, result.run.name, ixos::printable(what),
                     result.wall_seconds, reused ? " (reused)" : "");
  std::fflush(stdout);
}

int make(const Product& product, const std::string& folder, bool quiet) {
  const std::string script_file = report_script(product.script), log = folder + "/report.log";
  ixos::ChildProcess script({script_file, folder}, log);
  ixos::ChildOutcome outcome;
  while (!script.ended(outcome)) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  if (outcome.exit_status == 0) {
    std::filesystem::remove(log);
    if (!quiet) ixos::console::say("{}: {}/{}\n", product.name, ixos::printable(folder), product.file);
    return 0;
  }
  ixos::console::complain(
      "ixos-study: {} is complete, but the script for plots and report failed; {} has its messages (it needs "
      "python3 with matplotlib). To repeat it: {} {}\n",
      product.data, ixos::printable(log), script_file, ixos::printable(folder));
  return 4;
}

int run_advice(const Arguments& arguments) {
  const std::string folder = ixos::advice_folder(arguments.advice, arguments.output);
  const int status = ixos::advise(arguments.advice, arguments.output, (own_folder() / "ixos").string(),
                                  arguments.overwrite, arguments.quiet);
  if (status != 0 && status != 3) return status;
  const int written = make(advice_report, folder, arguments.quiet);
  return status != 0 ? status : written;
}

int run_scan(const Arguments& arguments) {
  const int status =
      ixos::scan(arguments.scan, {arguments.advice.assignments, arguments.output, (own_folder() / "ixos").string(),
                                  arguments.advice.jobs, arguments.overwrite, arguments.list, arguments.quiet});
  if (status != 0 || arguments.list) return status;
  return make(scan_picture, ixos::scan_folder(arguments.scan, arguments.output), arguments.quiet);
}

int run(const Arguments& arguments) {
  if (!arguments.scan.scene.empty()) return run_scan(arguments);
  if (!arguments.advice.scene.empty()) return run_advice(arguments);
  const ixos::Study study = ixos::read_study(arguments.study);
  if (arguments.list) {
    for (const ixos::StudyRun& run : study.runs)
      ixos::console::say("{}: {}\n", run.name, ixos::printable(fmt::format("{}", fmt::join(run.settings, "; "))));
    return 0;
  }
  ixos::RunnerOptions options;
  options.folder =
      arguments.output.empty() ? std::filesystem::path(arguments.study).stem().string() + ".results" : arguments.output;
  options.driver = (own_folder() / "ixos").string();
  options.version = IXOS_VERSION;
  options.overwrite = arguments.overwrite;
  options.command = "ixos-study " + ixos::shell_word(arguments.study) +
                    (arguments.output.empty() ? "" : " --output " + ixos::shell_word(arguments.output));
  options.interrupted = ixos::signalled;
  if (!arguments.quiet)
    options.watch = [&](const ixos::StudyResult& result, std::size_t done, bool reused) {
      print_run(result, done, result.run.labels.empty() ? 1 : study.runs.size(), study.question.measure, reused);
    };
  ixos::catch_signals();
  if (!arguments.quiet) ixos::note_jobs(study.jobs);
  const ixos::StudyOutcome outcome = ixos::run_study(study, options);
  if (outcome.status == ixos::StudyStatus::ReferenceFailed) {
    const ixos::StudyResult& reference = outcome.results.front();
    ixos::console::complain("ixos-study: the reference did not reach its end: {}: {}\n", reference.status,
                            ixos::printable(reference.reason));
    return 3;
  }
  if (outcome.status == ixos::StudyStatus::Interrupted) {
    ixos::console::complain("ixos-study: interrupted; run the same command again to resume\n");
    return 5;
  }
  if (!arguments.quiet) ixos::console::say("{}\n", ixos::printable(outcome.recommendation));
  return make(study_report, options.folder, arguments.quiet);
}

int guarded(const Arguments& arguments) {
  const std::string& file = !arguments.scan.scene.empty()     ? arguments.scan.scene
                            : !arguments.advice.scene.empty() ? arguments.advice.scene
                                                              : arguments.study;
  try {
    return run(arguments);
  } catch (const ixos::InputError& error) {
    const std::string what = error.what();
    ixos::console::complain("ixos-study: {}\n", ixos::printable(what.rfind(file, 0) == 0 ? what : file + ": " + what));
    return 2;
  } catch (const ixos::FileError& error) {
    ixos::console::complain("ixos-study: {}\n", ixos::printable(error.what()));
    return 4;
  } catch (const std::bad_alloc&) {
    ixos::console::complain("ixos-study: {}\n", ixos::out_of_memory());
    return 3;
  } catch (const std::exception& error) {
    ixos::console::complain("ixos-study: internal error, please report it: {}\n", ixos::printable(error.what()));
    return 1;
  }
}

void declare(CLI::App& app, Arguments& arguments) {
  ixos::set_help(app, examples, remark);
  CLI::Option* study = app.add_option("STUDY", arguments.study, "study file (XML)")->type_name("FILE");
  app.add_option("--output", arguments.output,
                 "results folder (default: the name of STUDY with .results instead of .xml)")
      ->type_name("FOLDER");
  app.add_flag("--overwrite", arguments.overwrite, "replace the results of another study in the results folder");
  app.add_flag("--list", arguments.list, "print the runs and their settings without running them");
  ixos::declare_advice(app, arguments.advice);
  ixos::declare_scan(app, arguments.scan);
  app.get_option("--advise")->excludes(study);
  app.get_option("--scan")->excludes(study)->excludes(app.get_option("--advise"));
  app.add_option("--set", arguments.advice.assignments,
                 "\"List/Sublist/Name=value\": changes the scene of --advise or --scan; may be repeated")
      ->type_name("ASSIGNMENT")
      ->allow_extra_args(false);
  app.add_option("--jobs", arguments.advice.jobs, "runs at the same time of --advise or --scan (default: 1)")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, 1024));
  app.add_flag_callback("--trust-geometry", ixos::trust_geometry,
                        "let scripts of drawings (.geo) start programs and write files");
  app.add_flag("--parameters", arguments.parameters, "print every parameter of a study, as Markdown");
  app.add_flag("--completion", arguments.completion, "print the script that completes commands of ixos-study in bash");
  app.add_flag("--version", arguments.version, "print the version");
  app.add_flag("--quiet", arguments.quiet, "print errors only");
}

int answer(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Runs a scene with many settings and compares their accuracy and cost.", "ixos-study");
  declare(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    ixos::console::print(app.help());
    return 0;
  } catch (const CLI::ParseError& error) {
    ixos::console::complain("ixos-study: {} (ixos-study --help lists the options)\n", error.what());
    return 2;
  }
  if (app.count("--set") + app.count("--jobs") > 0 && arguments.advice.scene.empty() && arguments.scan.scene.empty()) {
    ixos::console::complain("ixos-study: --set and --jobs need --advise or --scan; a study has lists for them\n");
    return 2;
  }
  if (!arguments.study.empty() || !arguments.advice.scene.empty() || !arguments.scan.scene.empty())
    return guarded(arguments);
  if (arguments.version)
    ixos::console::say("ixos-study {}\n", IXOS_VERSION);
  else if (arguments.parameters)
    ixos::console::say("{}", ixos::parameter_documentation(ixos::study_parameters(), "Parameters of a study",
                                                           "ixos-study --parameters"));
  else if (arguments.completion)
    ixos::console::print(ixos::bash_completion(app, {}, ixos::assignments(ixos::scene_parameters())));
  else
    ixos::console::print(how_to_begin());
  return 0;
}

int parse_and_run(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // lost output is an error of writing
  const int status = answer(argc, argv);
  const std::string lost = ixos::console::lost();
  if (status != 0 || lost.empty()) return status;
  ixos::console::complain("ixos-study: {}\n", lost);
  return 4;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ixos-study: cannot start: %s\n", error.what());
  } catch (...) {
    std::fprintf(stderr, "ixos-study: internal error, please report it\n");
  }
  return 1;
}
