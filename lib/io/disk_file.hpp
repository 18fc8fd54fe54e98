/// Files whose fate on the disk matters.
#pragma once
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>

namespace ixos {

/// An open file (or, to be read, a folder); pipes and devices are refused. Every failure throws FileError with the path
/// and the system's words.
class DiskFile {
 public:
  /// Change: of a file that exists. Create: empties one that does; a link goes.
  enum class Mode { Read, Change, Create };
  DiskFile(const std::string& path, Mode mode);
  ~DiskFile();
  DiskFile(const DiskFile&) = delete;
  DiskFile& operator=(const DiskFile&) = delete;

  std::uint64_t length() const;
  void seek(std::uint64_t position);
  /// Fills the buffer as far as the file goes; returns the number of bytes.
  std::size_t read(void* data, std::size_t size);
  void write(const void* data, std::size_t size);
  /// Takes room on the disk for a file of that length, without making it longer. Does nothing on a file system that
  /// cannot.
  void reserve(std::uint64_t bytes);
  /// The same, and makes the file that long where it is shorter: on any file system.
  void lengthen(std::uint64_t bytes);
  void give_back();  ///< reserved room beyond the file's end
  void sync();       ///< until the disk has it

 private:
  [[noreturn]] void fail(const char* what) const;
  std::string path_;
  int descriptor_;
};

/// Whether the path leads to a file: a pipe would have its reader wait, a device never end.
bool is_file(const std::string& path);

/// A text to read; not open where the path does not lead to a file.
std::ifstream open_text(const std::string& path);

/// A link goes: what is to be written is not to end up where it leads.
void remove_link(const std::string& path);

/// Has the disk keep what was written to a file, or a folder's names. Throws FileError.
void sync_to_disk(const std::string& path);

/// Where a file is made until it is finished and replace_file() puts it in its place.
std::string beside(const std::string& path);

/// Puts a finished file in the place of another, in one step that outlives a crash: whoever looks sees the old one or
/// the new one. Throws FileError.
void replace_file(const std::string& finished, const std::string& path);

/// Writes a file beside its place and puts it there: nobody sees half of it. Throws FileError.
void write_whole_file(const std::string& path, const std::string& text);

}  // namespace ixos
