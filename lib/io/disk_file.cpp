#include "io/disk_file.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "io/persistent.hpp"

namespace ixos {
namespace {

[[noreturn]] void fail_at(const std::string& path, const char* what) {
  throw FileError(path + ": " + what + ": " + std::strerror(errno));
}

int flags_of(DiskFile::Mode mode) {
  const int common = O_CLOEXEC | O_NONBLOCK;  // a pipe would wait
  if (mode == DiskFile::Mode::Read) return common | O_RDONLY;
  return common | O_RDWR | (mode == DiskFile::Mode::Create ? O_CREAT | O_TRUNC : 0);
}

}  // namespace

DiskFile::DiskFile(const std::string& path, Mode mode) : path_(path) {
  if (mode == Mode::Create) remove_link(path);
  descriptor_ = open(path.c_str(), flags_of(mode), 0666);
  if (descriptor_ < 0) fail(mode == Mode::Create ? "cannot be written" : "cannot be opened");
  struct stat status {};
  if (fstat(descriptor_, &status) == 0 && (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode))) return;
  ::close(descriptor_);
  throw FileError(path + ": is not a file");
}

DiskFile::~DiskFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void DiskFile::fail(const char* what) const { fail_at(path_, what); }

std::uint64_t DiskFile::length() const {
  struct stat status {};
  if (fstat(descriptor_, &status) != 0) fail("cannot be read");
  return static_cast<std::uint64_t>(status.st_size);
}

std::size_t DiskFile::read_at(std::uint64_t position, void* data, std::size_t size) const {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = persistent([&] {
      return pread(descriptor_, static_cast<char*>(data) + done, size - done, static_cast<off_t>(position + done));
    });
    if (count < 0) fail("cannot be read");
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return done;
}

void DiskFile::write_at(std::uint64_t position, const void* data, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = persistent([&] {
      return pwrite(descriptor_, static_cast<const char*>(data) + done, size - done,
                    static_cast<off_t>(position + done));
    });
    if (count == 0) errno = ENOSPC;  // no progress, and no reason given
    if (count <= 0) fail("cannot be written");
    done += static_cast<std::size_t>(count);
  }
}

void DiskFile::reserve(std::uint64_t bytes) {
  if (bytes == 0) return;
  const int status =
      persistent([&] { return fallocate(descriptor_, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes)); });
  if (status != 0 && errno != EOPNOTSUPP && errno != ENOSYS) fail("cannot be written");
}

void DiskFile::lengthen(std::uint64_t bytes) {
  reserve(bytes);
  if (length() < bytes) set_length(bytes);
}

void DiskFile::set_length(std::uint64_t bytes) {
  if (persistent([&] { return ftruncate(descriptor_, static_cast<off_t>(bytes)); }) != 0) fail("cannot be written");
}

void DiskFile::sync() {
  if (persistent([&] { return fsync(descriptor_); }) != 0) fail("cannot be written");
}

void DiskFile::close() {
  // The descriptor is gone even if this fails, with EINTR too.
  const int status = ::close(std::exchange(descriptor_, -1));
  if (status != 0 && errno != EINTR) fail("cannot be written");
}

bool is_file(const std::string& path) {
  std::error_code code;
  return std::filesystem::is_regular_file(path, code);
}

std::vector<std::string> names_in(const std::string& folder) {
  // Not std::filesystem's iterator, which ends the program where memory runs out.
  const std::unique_ptr<DIR, int (*)(DIR*)> stream(opendir(folder.empty() ? "." : folder.c_str()), closedir);
  if (!stream) {
    if (errno == ENOENT || errno == ENOTDIR) return {};
    fail_at(folder, "cannot be read");
  }
  std::vector<std::string> names;
  for (errno = 0; const dirent* entry = readdir(stream.get()); errno = 0)
    if (const std::string name = entry->d_name; name != "." && name != "..") names.push_back(name);
  if (errno != 0) fail_at(folder, "cannot be read");
  return names;
}

std::ifstream open_text(const std::string& path) { return is_file(path) ? std::ifstream(path) : std::ifstream(); }

std::string read_whole_file(const std::string& path) {
  const DiskFile file(path, DiskFile::Mode::Read);
  std::string bytes(file.length(), '\0');
  bytes.resize(file.read_at(0, bytes.data(), bytes.size()));
  return bytes;
}

void remove_link(const std::string& path) {
  std::error_code code;
  if (std::filesystem::is_symlink(path, code)) std::filesystem::remove(path, code);
}

void sync_to_disk(const std::string& path) {
  DiskFile file(path, DiskFile::Mode::Read);
  file.sync();
  file.close();
}

std::string beside(const std::string& path) { return path + ".tmp"; }

void replace_file(const std::string& finished, const std::string& path) {
  if (std::rename(finished.c_str(), path.c_str()) != 0) fail_at(path, "cannot be written");
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  sync_to_disk(folder.empty() ? "." : folder.string());
}

void write_whole_file(const std::string& path, const std::string& text) {
  const std::string unfinished = beside(path);
  try {
    DiskFile file(unfinished, DiskFile::Mode::Create);
    file.write_at(0, text.data(), text.size());
    file.sync();
    file.close();
    replace_file(unfinished, path);
  } catch (const FileError&) {
    std::remove(unfinished.c_str());
    throw;
  }
}

}  // namespace ixos
