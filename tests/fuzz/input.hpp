/// What the fuzz targets share: each defines LLVMFuzzerTestOneInput, which libFuzzer, or replay.cpp, calls.
#pragma once
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "scene/simulation.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace ixos::fuzz {

/// Ends the program, as a finding, where the condition does not hold.
void expect(bool holds, const char* what);

/// A refusal must say something.
void expect_message(const std::exception& error);

std::string text(const std::uint8_t* data, std::size_t size);

/// The pieces of a text between separators; `count` of them, the last with all that is left.
std::vector<std::string> pieces(const std::string& text, const std::string& separator, std::size_t count);

/// A file in memory that goes with this object.
class MemoryFile {
 public:
  MemoryFile(const void* data, std::size_t size);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const;

 private:
  int descriptor_;
};

/// An empty folder of this process, in $TMPDIR or /tmp, removed when it ends.
const std::string& scratch_folder();
void write_file(const std::string& path, const std::string& contents);

/// A scene of one cell above a wall, held at its top, with a probe and a reaction; and the format of its fields.
std::string small_scene(const std::string& scheme = "Central Difference", const std::string& fields = "Exodus");

/// Starts MPI, once.
Comm comm();

/// small_scene() made ready to run, at rest. It takes long to make: the same is given some 200 times.
Simulation& simulation(const std::string& scheme, const std::string& fields = "Exodus");

}  // namespace ixos::fuzz
