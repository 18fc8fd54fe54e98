#include "ixos-study/scan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "base/printable.hpp"
#include "console.hpp"
#include "shell_word.hpp"
#include "signals.hpp"
#include "study/scan/scan_table.hpp"

namespace ixos {
namespace {

/// Returns the command that repeats a scan.
std::string command_of(const ScanArguments& arguments, const ScanSettings& settings) {
  std::string text = "ixos-study --scan " + shell_word(arguments.scene);
  for (const std::string& varied : arguments.varied) text += " --vary " + shell_word(varied);
  for (const std::string& quantity : arguments.quantities) text += " --collect " + shell_word(quantity);
  for (const std::string& assignment : settings.assignments) text += " --set " + shell_word(assignment);
  return text + (settings.output.empty() ? "" : " --output " + shell_word(settings.output));
}

bool has_value(const ScanRow& row) {
  for (const double value : row.values)
    if (std::isfinite(value)) return true;
  return false;
}

void print_run(const ScanRow& row, std::size_t done, std::size_t total, bool reused) {
  std::string what = row.status;
  if (!row.reason.empty()) what += ": " + row.reason;
  console::say("[{}/{}] {}: {}, {:.3g} s{}\n", done, total, row.run.name, printable(what), row.wall_seconds,
               reused ? " (reused)" : "");
  std::fflush(stdout);
}

}  // namespace

void declare_scan(CLI::App& app, ScanArguments& arguments) {
  CLI::Option* scan =
      app.add_option("--scan", arguments.scene, "run this scene (XML) with varied parameters, in place of a study")
          ->type_name("FILE");
  app.add_option("--vary", arguments.varied,
                 "\"List/Sublist/Name=from:to:number\", with :log behind for equal ratios, or "
                 "\"List/Sublist/Name={one, two}\"; of several, all combinations are run")
      ->type_name("RANGE")
      ->allow_extra_args(false)
      ->needs(scan);
  scan->needs(app.get_option("--vary"));
  app.add_option("--collect", arguments.quantities,
                 "number to collect from each run, such as \"peak reaction_right_y\"; may be repeated (default: "
                 "Output/Quantities of the scene)")
      ->type_name("QUANTITY")
      ->allow_extra_args(false)
      ->needs(scan);
}

std::string scan_folder(const ScanArguments& arguments, const std::string& output) {
  return output.empty() ? std::filesystem::path(arguments.scene).stem().string() + "-scan.results" : output;
}

int scan(const ScanArguments& arguments, const ScanSettings& settings) {
  Scan asked{arguments.scene, settings.assignments, {}, {}};
  for (const std::string& text : arguments.varied) asked.varied.push_back(read_varied(text));
  for (const std::string& text : arguments.quantities) asked.quantities.emplace_back(text);
  const std::vector<StudyRun> runs = runs_of(asked);
  if (settings.list) {
    for (const StudyRun& run : runs)
      console::say("{}: {}\n", run.name, printable(fmt::format("{}", fmt::join(run.settings, "; "))));
    return 0;
  }
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  if (!settings.quiet && processors > 0 && settings.jobs > processors)
    console::say("Note: {} jobs share {} processors: each run takes longer\n", settings.jobs, processors);
  ScanOptions options;
  options.folder = scan_folder(arguments, settings.output);
  options.driver = settings.driver;
  options.command = command_of(arguments, settings);
  options.version = IXOS_VERSION;
  options.jobs = settings.jobs;
  options.overwrite = settings.overwrite;
  options.interrupted = signalled;
  if (!settings.quiet)
    options.watch = [&](const ScanRow& row, std::size_t done, bool reused) {
      print_run(row, done, runs.size(), reused);
    };
  catch_signals();
  const ScanOutcome outcome = run_scan(asked, options);
  if (!settings.quiet) console::say("{}", printable(scan_text(asked, outcome.rows)));
  if (!outcome.complete) {
    console::complain("ixos-study: interrupted; run the same command again to resume\n");
    return 5;
  }
  for (const ScanRow& row : outcome.rows)
    if (has_value(row)) return 0;
  console::complain("ixos-study: no run has a value; {}/scan.csv has the reasons\n", printable(options.folder));
  return 3;
}

}  // namespace ixos
