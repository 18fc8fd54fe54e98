/// The command line of ixos.
#pragma once
#include <string>
#include <vector>

namespace ixos {

struct Arguments {
  std::string scene;
  std::vector<std::string> assignments;
  std::string output;
  std::string restart;
  std::string template_name;
  std::string mesh_file;
  double accuracy = 0;  ///< relative, of the quantities that the scene names; 0: not asked for
  bool overwrite = false;
  bool check = false;
  bool tries = false;  ///< --try
  bool explain = false;
  bool verify_restart = false;
  int kills = 3;                 ///< of --verify-restart
  std::vector<long> kill_steps;  ///< of --verify-restart; ascending
  int ranks = 1;                 ///< of the processes that --verify-restart starts
  long kill_after_step = 0;      ///< 0: never. Not listed by --help: see --verify-restart
  bool parameters = false;
  bool list_schemes = false;
  bool completion = false;
  bool version = false;
  bool quiet = false;
};

/// The meaning of a command line. `error` says why it was refused and `help` is the answer to --help; if both are
/// empty, the arguments hold.
struct CommandLine {
  Arguments arguments;
  std::string help, error;
};

/// Reads a command line. Needs no MPI.
CommandLine parse(int argc, char** argv);

/// Returns the script that completes commands of ixos in bash: options, parameters and values of --set.
std::string completion_script();

/// Returns how to begin: the answer to a call without arguments.
std::string how_to_begin();

/// Returns the folder for the results: --output, or the scene file's name without its folder and ending, with `ending`.
std::string results_folder(const Arguments& arguments, const std::string& ending = ".results");

/// Returns the message of bad input with the scene file before it, unless it names its place itself.
std::string with_place(const std::string& message, const Arguments& arguments);

}  // namespace ixos
