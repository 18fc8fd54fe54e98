/// Texts cut into pieces.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace ixos {

/// Returns the text without blanks, tabs and line ends around it.
inline std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// Returns the pieces between separators, trimmed; the whole text if it has no separator.
inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> pieces;
  for (std::size_t start = 0, end = 0; end != std::string::npos; start = end + 1) {
    end = text.find(separator, start);
    pieces.push_back(trimmed(text.substr(start, end == std::string::npos ? end : end - start)));
  }
  return pieces;
}

}  // namespace ixos
