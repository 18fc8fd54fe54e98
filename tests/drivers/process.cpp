#include "drivers/process.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace ixos::test {
namespace {

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

std::string quoted_driver() { return quoted(IXOS_DRIVER); }

Outcome ixos(const std::vector<std::string>& arguments, const std::string& folder) {
  return program(IXOS_DRIVER, arguments, folder);
}

Outcome program(const std::string& path, const std::vector<std::string>& arguments, const std::string& folder) {
  std::string command = quoted(path);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  return shell(command, folder);
}

Outcome shell(const std::string& command, const std::string& folder) {
  std::FILE* pipe = popen(("exec 2>&1; cd " + quoted(folder) + " || exit; " + command).c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run the driver");
  std::string output;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) output += buffer.data();
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), output};
}

std::string scratch_folder() {
  char name[] = "/tmp/ixos-test-XXXXXX";
  if (mkdtemp(name) == nullptr) throw std::runtime_error("cannot make a scratch folder");
  return name;
}

}  // namespace ixos::test
