/// The place of an error, for the user.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

namespace ixos {

/// Returns the message of an InputError with the scene's file before it, unless the message begins with that file or
/// with one of the other places already: an absolute path, an option, the results folder, a checkpoint. Every
/// program that runs scenes reports the same text. An empty file adds nothing.
inline std::string placed_message(const std::string& message, const std::string& file,
                                  const std::vector<std::string>& other_places = {}) {
  const auto begins = [&message](const std::string& place) { return !place.empty() && message.rfind(place, 0) == 0; };
  if (file.empty() || begins(file) || begins("--") || begins("/")) return message;
  if (std::any_of(other_places.begin(), other_places.end(), begins)) return message;
  return file + ": " + message;
}

}  // namespace ixos
