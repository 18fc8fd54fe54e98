/// What is refused, and in which words.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"

namespace ixos::test {

/// The message of the InputError that `action` throws; empty where it throws none.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The message of the FileError that `action` throws; empty where it throws none.
template <class Action>
std::string file_failure(const Action& action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

inline void expect_contains(const std::string& message, const std::string& words) {
  EXPECT_NE(message.find(words), std::string::npos) << "message: " << message << "\nexpected: " << words;
}

}  // namespace ixos::test
