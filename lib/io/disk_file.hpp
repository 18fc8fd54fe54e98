/// Files whose fate on the disk matters.
#pragma once
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace ixos {

/// An open file (or, to be read, a folder). Refuses pipes and devices. Every failure throws FileError with the path
/// and the system's words. Repeats calls that a signal interrupted or that transferred a part only.
class DiskFile {
 public:
  /// Change: opens an existing file. Create: makes an empty file; removes a link at its place first.
  enum class Mode { Read, Change, Create };
  DiskFile(const std::string& path, Mode mode);
  /// Closes the file and ignores errors: call close() before where anything was written.
  ~DiskFile();
  DiskFile(const DiskFile&) = delete;
  DiskFile& operator=(const DiskFile&) = delete;

  std::uint64_t length() const;
  /// Fills the buffer from that position as far as the file goes; returns the number of bytes.
  std::size_t read_at(std::uint64_t position, void* data, std::size_t size) const;
  void write_at(std::uint64_t position, const void* data, std::size_t size);
  /// Takes room on the disk for a file of that length, without making it longer. Does nothing on a file system that
  /// cannot.
  void reserve(std::uint64_t bytes);
  /// Reserves the room, and makes the file that long if it is shorter: on any file system.
  void lengthen(std::uint64_t bytes);
  /// Cuts the file, or makes it longer. Reserved room beyond its end is released.
  void set_length(std::uint64_t bytes);
  void sync();  ///< returns when the disk has everything
  /// Closes the file. Some file systems report a failed write only here.
  void close();

 private:
  [[noreturn]] void fail(const char* what) const;
  std::string path_;
  int descriptor_;
};

/// Returns whether the path leads to a file: a pipe would make its reader wait, a device never ends.
bool is_file(const std::string& path);

/// Returns the names in a folder, in no order; none if there is no such folder. Throws FileError if it cannot be read.
std::vector<std::string> names_in(const std::string& folder);

/// Opens a text to read; the stream is not open if the path does not lead to a file.
std::ifstream open_text(const std::string& path);

/// Returns the bytes of a file. Throws FileError if the path leads to none, or if it cannot be read.
std::string read_whole_file(const std::string& path);

/// Removes a symbolic link, so that a write does not end where it leads.
void remove_link(const std::string& path);

/// Makes the disk keep what was written to a file, or the names in a folder. Throws FileError.
void sync_to_disk(const std::string& path);

/// Returns the path at which a file is written until replace_file() puts it in its place.
std::string beside(const std::string& path);

/// Renames a finished file to `path` in one step that outlives a crash: a reader sees the old file or the new one.
/// Throws FileError.
void replace_file(const std::string& finished, const std::string& path);

/// Writes a file beside its place, syncs it, and renames it: nobody sees half of it. Throws FileError; the unfinished
/// file is removed then.
void write_whole_file(const std::string& path, const std::string& text);

}  // namespace ixos
