/// An open Exodus file. Included by lib/io only.
#pragma once
#include <exodusII.h>

#include <string>

namespace ixos {

/// Closes the file when it goes.
class ExodusHandle {
 public:
  ExodusHandle(int id, std::string path) : id_(id), path_(std::move(path)) {}
  ~ExodusHandle() { ex_close(id_); }
  ExodusHandle(const ExodusHandle&) = delete;
  ExodusHandle& operator=(const ExodusHandle&) = delete;

  operator int() const { return id_; }  // NOLINT: passed to the C interface as it is
  const std::string& path() const { return path_; }

 private:
  int id_;
  std::string path_;
};

}  // namespace ixos
