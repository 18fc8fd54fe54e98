/// Commands to copy into a shell.
#pragma once
#include <algorithm>
#include <cctype>
#include <cstring>
#include <string>

namespace ixos {

/// As a shell takes it for one word.
inline std::string shell_word(const std::string& word) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || std::strchr("/._-=+,:%@", c) != nullptr; };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string text = "'";
  for (char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace ixos
