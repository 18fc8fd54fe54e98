/// The command that repeats a scan.
#pragma once
#include <string>
#include <vector>

#include "shell_word.hpp"

namespace ixos {

/// Returns "ixos-study --scan ..." of these words; `output` may be empty.
inline std::string scan_command(const std::string& scene, const std::vector<std::string>& varied,
                                const std::vector<std::string>& quantities, const std::vector<std::string>& assignments,
                                const std::string& output) {
  std::string text = "ixos-study --scan " + shell_word(scene);
  for (const std::string& word : varied) text += " --vary " + shell_word(word);
  for (const std::string& word : quantities) text += " --collect " + shell_word(word);
  for (const std::string& word : assignments) text += " --set " + shell_word(word);
  return text + (output.empty() ? "" : " --output " + shell_word(output));
}

}  // namespace ixos
