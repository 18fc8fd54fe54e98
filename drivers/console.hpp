// Output on standard output and standard error, with its failures.
#pragma once
#include <fmt/format.h>

#include <string>

namespace ixos::console {

/// Prints to standard output. Remembers a failure and does not throw, so that a run continues.
void print(const std::string& text);

template <class... Values>
void say(fmt::format_string<Values...> text, Values&&... values) {
  print(fmt::format(text, std::forward<Values>(values)...));
}

void flush();

/// Prints to standard error, unbuffered. Nobody is left to be told of a failure.
void print_error(const std::string& text);

template <class... Values>
void complain(fmt::format_string<Values...> text, Values&&... values) {
  print_error(fmt::format(text, std::forward<Values>(values)...));
}

/// Flushes standard output. Returns why something that was printed is lost; empty where nothing is.
std::string lost();

}  // namespace ixos::console
