/// An open Exodus file. Included by lib/io only.
#pragma once
#include <exodusII.h>

#include <string>

namespace ixos {

/// An open Exodus file. The destructor closes it and ignores errors: close() what was written.
class ExodusHandle {
 public:
  ExodusHandle(int id, std::string path) : id_(id), path_(std::move(path)) {}
  ~ExodusHandle() { close(); }
  ExodusHandle(const ExodusHandle&) = delete;
  ExodusHandle& operator=(const ExodusHandle&) = delete;

  operator int() const { return id_; }  // NOLINT: passed to the C interface as it is
  const std::string& path() const { return path_; }
  /// Returns a negative status, as the library does, if the file cannot be closed: then some data were not written.
  int close() {
    const int status = id_ >= 0 ? ex_close(id_) : 0;
    id_ = -1;
    return status;
  }

 private:
  int id_;
  std::string path_;
};

}  // namespace ixos
