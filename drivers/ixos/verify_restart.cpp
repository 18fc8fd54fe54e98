#include "ixos/verify_restart.hpp"

#include <csignal>
#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/printable.hpp"
#include "console.hpp"
#include "scene/read/parameters.hpp"
#include "scene/scene_file.hpp"
#include "signals.hpp"
#include "study/restart/restart_check.hpp"

namespace ixos {
namespace {

int refuse(int status, const std::string& what) {
  console::complain("ixos: {}\n", printable(what));
  return status;
}

RestartCheck restart_check(const Arguments& arguments) {
  RestartCheck check;
  if (arguments.ranks > 1) check.driver = {"/usr/bin/env", "mpirun", "-np", std::to_string(arguments.ranks)};
  check.driver.push_back(std::filesystem::read_symlink("/proc/self/exe").string());
  check.scene = arguments.scene;
  check.settings = arguments.assignments;
  check.folder = results_folder(arguments, ".restarts");
  check.overwrite = arguments.overwrite;
  check.steps = arguments.kill_steps;
  check.kills = arguments.kills;
  if (!arguments.quiet)
    check.log = [](const std::string& line) {
      console::say("{}\n", printable(line));
      console::flush();
    };
  check.interrupted = signalled;
  return check;
}

int run_check(const Arguments& arguments) {
  Teuchos::ParameterList scene = read_scene_file(arguments.scene);
  for (const std::string& assignment : arguments.assignments) set_parameter(scene, scene_parameters(), assignment);
  catch_signals();
  const RestartCheck check = restart_check(arguments);
  const RestartCheckResult result = check_restarts(check);
  switch (result.status) {
    case RestartCheckStatus::Same:
      if (!arguments.quiet) console::say("Restarts are verified.\n");
      return 0;
    case RestartCheckStatus::Different:
      return refuse(3, "a resumed run differs from the undisturbed one: " + result.message + ". The results are in " +
                           check.folder);
    case RestartCheckStatus::Unrepeatable:
      return refuse(3, "two runs of the scene differ before the first restart: " + result.message +
                           ". Restarts of such a scene cannot be verified: see the user guide, \"Linear solvers\". The "
                           "results are in " +
                           check.folder);
    case RestartCheckStatus::Interrupted:
      return refuse(5, "interrupted");
    default:
      return refuse(result.exit_status, result.message);
  }
}

}  // namespace

int verify_restart(const Arguments& arguments) {
  std::signal(SIGPIPE, SIG_IGN);  // lost output is an error of writing
  if (arguments.scene.empty()) return refuse(2, "a scene is needed: ixos SCENE.xml --verify-restart");
  try {
    const int status = run_check(arguments);
    const std::string lost = console::lost();
    return status != 0 || lost.empty() ? status : refuse(4, lost);
  } catch (const InputError& error) {
    return refuse(2, with_place(error.what(), arguments));
  } catch (const FileError& error) {
    return refuse(4, error.what());
  } catch (const std::bad_alloc&) {
    return refuse(3, out_of_memory());
  } catch (const std::exception& error) {
    return refuse(1, std::string("internal error, please report it: ") + error.what());
  }
}

}  // namespace ixos
