/// Trying out what may crash.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

namespace ixos {

/// Runs a function in a child process that ends with it: a copy of this one, so nothing that the function changes in
/// memory is changed here. It may take `bytes` of memory beyond what is taken now, `seconds` (0: any) of processor
/// time, and three times as many of the clock. Returns "" where the function returned; what it threw, in words (their
/// first 4000 bytes); or "reading it crashes", "reading it takes too long". For files that distribution libraries read,
/// which are not all safe against harmful ones. The function must not communicate with other ranks. Throws FileError
/// where no process can be started.
std::string trial(const std::function<void()>& function, std::uint64_t bytes, unsigned seconds);

/// The trial of reading a file: memory and time in proportion to its length. Throws InputError with the path where it
/// did not end well, so that this process reads none but sound files.
void try_reading(const std::string& path, const std::function<void()>& function);

/// Lets a child process write a file with a library that may crash where the disk fails. `room` is about the file's
/// length, in bytes. Throws FileError with the path if the child did not end well.
void write_apart(const std::string& path, std::uint64_t room, const std::function<void()>& function);

}  // namespace ixos
