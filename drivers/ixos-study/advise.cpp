#include "ixos-study/advise.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "base/text.hpp"
#include "console.hpp"
#include "ixos-study/jobs.hpp"
#include "parameters/scene_node.hpp"
#include "shell_word.hpp"
#include "signals.hpp"
#include "study/advice/advice_report.hpp"
#include "study/common/tolerance.hpp"

namespace ixos {
namespace {

/// Returns the command that repeats an advice.
std::string command_of(const AdviceArguments& arguments, const std::string& output) {
  std::string text = "ixos-study --advise " + shell_word(arguments.scene);
  for (const std::string& quantity : arguments.quantities) text += " --quantity " + shell_word(quantity);
  text += " --tolerance " + shell_word(arguments.tolerance);
  for (const std::string& assignment : arguments.assignments) text += " --set " + shell_word(assignment);
  if (arguments.budget > 0) text += fmt::format(" --budget {}", arguments.budget);
  if (arguments.verify) text += " --verify";
  return text + (output.empty() ? "" : " --output " + shell_word(output));
}

/// Returns the quantities that the scene names.
std::vector<AskedQuantity> quantities_of_scene(const AdviceArguments& arguments) {
  Teuchos::ParameterList scene = changed_scene(arguments.scene, arguments.assignments);
  std::vector<AskedQuantity> quantities;
  at(arguments.scene + ": Output/Quantities", [&] {
    for (const std::string& text : scene.sublist("Output").get<Teuchos::Array<std::string>>("Quantities"))
      quantities.emplace_back(text);
  });
  return quantities;
}

int exit_status(AdviceStatus status) {
  if (status == AdviceStatus::Advised) return 0;
  return status == AdviceStatus::Interrupted ? 5 : 3;
}

}  // namespace

void declare_advice(CLI::App& app, AdviceArguments& arguments) {
  CLI::Option* advise =
      app.add_option("--advise", arguments.scene, "recommend settings for this scene (XML) in place of a study")
          ->type_name("FILE");
  const auto add = [&](CLI::Option* option) { return option->needs(advise); };
  add(app.add_option(
             "--quantity", arguments.quantities,
             "number that counts, such as \"peak reaction_right_y\"; may be repeated (default: Output/Quantities of "
             "the scene)")
          ->type_name("QUANTITY")
          ->allow_extra_args(false));
  add(app.add_option("--tolerance", arguments.tolerance, "largest relative error of each quantity (default: 1%)")
          ->type_name("TOLERANCE"));
  add(app.add_option("--budget", arguments.budget,
                     "seconds of processor time that the advice may take (default: 8 times the scene as it is)")
          ->type_name("SECONDS")
          ->check(CLI::PositiveNumber));
  add(app.add_flag("--verify", arguments.verify,
                   "compare the recommended settings with half the step on a finer mesh"));
}

std::string advice_folder(const AdviceArguments& arguments, const std::string& output) {
  return output.empty() ? std::filesystem::path(arguments.scene).stem().string() + "-advice.results" : output;
}

int advise(const AdviceArguments& arguments, const std::string& output, const std::string& driver, bool overwrite,
           bool quiet) {
  AdviceQuestion question{arguments.scene, arguments.assignments, {}};
  question.tolerance = read_tolerance("--tolerance", arguments.tolerance);
  question.budget = arguments.budget;
  question.verify = arguments.verify;
  for (const std::string& quantity : arguments.quantities) question.quantities.emplace_back(quantity);
  if (question.quantities.empty()) question.quantities = quantities_of_scene(arguments);
  AdviceOptions options;
  options.folder = advice_folder(arguments, output);
  options.driver = driver;
  options.version = IXOS_VERSION;
  options.jobs = arguments.jobs;
  options.overwrite = overwrite;
  options.interrupted = signalled;
  if (!quiet)
    options.log = [](const std::string& line) {
      console::say("{}\n", printable(line));
      std::fflush(stdout);
    };
  if (!quiet) note_jobs(options.jobs);
  catch_signals();
  const Advice advice = advise(question, options);
  if (advice.status == AdviceStatus::Interrupted) {
    console::complain("ixos-study: interrupted; run the same command again to resume\n");
    return exit_status(advice.status);
  }
  write_advice(question, advice, options.folder, command_of(arguments, output), IXOS_VERSION);
  if (!quiet) {
    console::say("{}", printable(advice_text(question, advice)));
    if (advice.status == AdviceStatus::Advised)
      console::say("Scene with these settings: {}\n", printable(options.folder + "/advised.xml"));
  }
  return exit_status(advice.status);
}

}  // namespace ixos
