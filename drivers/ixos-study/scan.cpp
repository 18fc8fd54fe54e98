#include "ixos-study/scan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/printable.hpp"
#include "console.hpp"
#include "ixos-study/jobs.hpp"
#include "scan_command.hpp"
#include "signals.hpp"
#include "study/scan/scan_table.hpp"

namespace ixos {
namespace {

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
  const Scan asked = read_scan(arguments.scene, settings.assignments, arguments.varied, arguments.quantities);
  if (settings.list) {
    for (const StudyRun& run : asked.runs)
      console::say("{}: {}\n", run.name, printable(fmt::format("{}", fmt::join(run.settings, "; "))));
    return 0;
  }
  if (!settings.quiet) note_jobs(settings.jobs);
  ScanOptions options;
  options.folder = scan_folder(arguments, settings.output);
  options.driver = settings.driver;
  options.command =
      scan_command(arguments.scene, arguments.varied, arguments.quantities, settings.assignments, settings.output);
  options.version = IXOS_VERSION;
  options.jobs = settings.jobs;
  options.overwrite = settings.overwrite;
  options.interrupted = signalled;
  if (!settings.quiet)
    options.watch = [&](const ScanRow& row, std::size_t done, bool reused) {
      print_run(row, done, asked.runs.size(), reused);
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
