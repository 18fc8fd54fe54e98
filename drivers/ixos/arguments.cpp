#include "ixos/arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "completion.hpp"
#include "help.hpp"
#include "io/drawing.hpp"
#include "parameters/assignments.hpp"
#include "scene/explain/documentation.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/placed_message.hpp"
#include "study/common/tolerance.hpp"

namespace ixos {
namespace {

const char* const examples =
    "  ixos xml/ball.xml                          run the ball; results go to ball.results\n"
    "  ixos xml/ball.xml --check                  check the scene\n"
    "  ixos xml/ball.xml --try                    take a few steps, and say how long the run would take\n"
    "  ixos xml/ball.xml --explain                print what the scene models and what it leaves out\n"
    "  ixos xml/ball.xml --set \"Time Integrator/Type=Newmark\"   change a parameter\n"
    "  ixos xml/strip.xml --accuracy 1%           choose steps for an accuracy, and report the error\n"
    "  ixos xml/ball.xml --restart ball.results/checkpoint.h5   resume a run\n"
    "  ixos xml/ball.xml --verify-restart         verify that killed runs resume bit for bit\n"
    "  ixos --template block > block.xml          write a complete scene with every parameter explained\n"
    "  ixos --list-schemes                        describe the time integrators\n";

/// Returns a check that admits whole numbers from 1.
CLI::Validator positive() { return CLI::Range(1L, 999'999'999L).description(""); }

/// Adds the options of --verify-restart.
void add_verification(CLI::App& app, Arguments& arguments, const std::vector<CLI::Option*>& others) {
  CLI::Option* verify = app.add_flag("--verify-restart", arguments.verify_restart,
                                     "run the scene undisturbed, run it again with kills and restarts, and compare "
                                     "bit for bit; exit status 3 if anything differs");
  CLI::Option* kills = app.add_option("--kills", arguments.kills,
                                      "number of kills of --verify-restart, spread over the run (default: 3)")
                           ->type_name("N")
                           ->check(positive());
  CLI::Option* steps = app.add_option("--kill-steps", arguments.kill_steps,
                                      "steps from whose checkpoints --verify-restart resumes: 10,20,40")
                           ->type_name("STEPS")
                           ->delimiter(',')
                           ->allow_extra_args(false)
                           ->check(positive());
  CLI::Option* ranks =
      app.add_option("--ranks", arguments.ranks, "number of ranks of the runs of --verify-restart (default: 1)")
          ->type_name("N")
          ->check(positive());
  kills->needs(verify)->excludes(steps);
  steps->needs(verify);
  ranks->needs(verify);
  for (CLI::Option* other : others) verify->excludes(other);
  CLI::Option* kill = app.add_option("--kill-after-step", arguments.kill_after_step)->check(positive())->group("");
  verify->excludes(kill);
}

/// Declares all options.
void declare(CLI::App& app, Arguments& arguments) {
  set_help(app, examples);
  app.add_option("SCENE", arguments.scene, "scene file (XML)")->type_name("FILE");
  app.add_option("--set", arguments.assignments, "\"List/Sublist/Name=value\": changes the scene; may be repeated")
      ->type_name("ASSIGNMENT")
      ->allow_extra_args(false);
  app.add_option("--output", arguments.output, "folder for the results (default: SCENE without its ending, .results)")
      ->type_name("FOLDER");
  app.add_flag("--overwrite", arguments.overwrite,
               "replace the results of another scene in the results folder, or the file of --write-mesh");
  CLI::Option* accuracy =
      app.add_option_function<std::string>(
             "--accuracy", [&](const std::string& text) { arguments.accuracy = read_tolerance("--accuracy", text); },
             "run with ever finer adaptive steps until the error of each of Output/Quantities is at most this part of "
             "it, as 1%")
          ->type_name("ACCURACY");
  CLI::Option* restart =
      app.add_option("--restart", arguments.restart,
                     "resume from this checkpoint, or from the newest sound checkpoint of this folder")
          ->type_name("FILE")
          ->check([](const std::string& file) { return file.empty() ? "a file is needed" : ""; });
  CLI::Option* check = app.add_flag("--check", arguments.check, "check the scene and build it, but do not run it");
  CLI::Option* tries = app.add_flag("--try", arguments.tries,
                                    "take the first steps, say how long the whole run would take and what its warnings "
                                    "are, and keep nothing");
  CLI::Option* explain = app.add_flag("--explain", arguments.explain,
                                      "print what the scene models and what it leaves out, but do not run it");
  app.add_option("--template", arguments.template_name,
                 fmt::format("print a complete, commented scene: {}", fmt::join(template_names(), " or ")))
      ->type_name("NAME");
  CLI::Option* mesh =
      app.add_option(
             "--write-mesh", arguments.mesh_file,
             "write the scene's mesh to this file, of Exodus or, if it ends in .msh, of gmsh, but do not run it")
          ->type_name("FILE");
  accuracy->excludes(mesh);
  for (CLI::Option* other : {accuracy, restart, check, explain, mesh}) tries->excludes(other);
  add_verification(app, arguments, {accuracy, restart, check, explain, mesh, tries});
  app.add_flag_callback("--trust-geometry", ixos::trust_geometry,
                        "let scripts of drawings (.geo) start programs and write files");
  app.add_flag("--parameters", arguments.parameters, "print every parameter of a scene, as Markdown");
  app.add_flag("--list-schemes", arguments.list_schemes, "print the time integrators and what each is good for");
  app.add_flag("--completion", arguments.completion, "print the script that completes commands of ixos in bash");
  app.add_flag("--version", arguments.version, "print version and build");
  app.add_flag("--quiet", arguments.quiet, "print errors only");
}

}  // namespace

std::string how_to_begin() {
  return std::string("Ixos simulates dynamic adhesion. Give it a scene:\n") + examples +
         "  ixos --help                                list all options\n";
}

CommandLine parse(int argc, char** argv) {
  CommandLine line;
  CLI::App app("Ixos simulates dynamic adhesion.", "ixos");
  declare(app, line.arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    line.help = app.help();
  } catch (const CLI::ParseError& error) {
    line.error = error.what();
  } catch (const InputError& error) {
    line.error = error.what();
  }
  if (line.arguments.accuracy > 0 && !line.arguments.restart.empty())
    line.error =
        "--accuracy does not go with --restart: its runs differ in their steps, so each starts at the initial time; to "
        "finish a run that was interrupted, leave out --accuracy";
  std::vector<long>& steps = line.arguments.kill_steps;
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return line;
}

std::string completion_script() {
  Arguments arguments;
  CLI::App app("", "ixos");
  declare(app, arguments);
  return bash_completion(app, {{"--template", template_names()}}, assignments(scene_parameters()));
}

std::string results_folder(const Arguments& arguments, const std::string& ending) {
  return arguments.output.empty() ? std::filesystem::path(arguments.scene).stem().string() + ending : arguments.output;
}

std::string with_place(const std::string& message, const Arguments& arguments) {
  return placed_message(message, arguments.scene, {results_folder(arguments), arguments.restart});
}

}  // namespace ixos
