/// The kinds of failure that a user can correct. Any other exception is a defect of Ixos.
#pragma once
#include <new>
#include <stdexcept>
#include <string>

namespace ixos {

/// Bad input: a scene, a mesh, a command line or a file. The message names the place, the offending value and what is
/// allowed. The driver ends with exit status 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or folder could not be written or read. The driver ends with exit status 4.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Memory ran out, on any rank. The driver ends with exit status 3: more memory, or more ranks, let the run continue.
/// It is a std::bad_alloc, so that no caller takes it for a defect of the function that threw it.
class MemoryError : public std::bad_alloc {
 public:
  explicit MemoryError(const std::string& message) : message_(message) {}  // NOLINT(bugprone-throw-keyword-missing)
  const char* what() const noexcept override { return message_.what(); }

 private:
  std::runtime_error message_;  ///< copies without throwing
};

/// Returns the last paragraph of a message of Teuchos or NOX: the paragraphs before it say where the library threw.
inline std::string last_paragraph(std::string message) {
  const auto count = message.find("\nThrow number = ");
  if (count != std::string::npos && message.find("\n\n", count) == message.rfind("\n\n")) message.resize(count);
  while (!message.empty() && message.back() == '\n') message.pop_back();
  const auto start = message.rfind("\n\n");
  return start == std::string::npos ? message : message.substr(start + 2);
}

}  // namespace ixos
