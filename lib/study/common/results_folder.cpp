#include "study/common/results_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fstream>

#include "base/error.hpp"

namespace ixos {

ResultsFolder::ResultsFolder(const std::string& folder, const std::string& owner, bool overwrite) {
  const std::string lock = folder + "/lock";
  file_ = open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) throw FileError(folder + ": cannot be written");
  try {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0)
      throw FileError(folder +
                      ": another ixos-study uses this folder; wait until it has ended, or choose another --output");
    std::string found;
    std::ifstream before(lock);
    std::getline(before, found);
    if (found == owner) return;
    if (!found.empty() && !overwrite)
      throw InputError(folder + ": holds the results of " + found + ", and this is " + owner +
                       "; choose another --output, or replace them with --overwrite");
    const std::string line = owner + '\n';
    if (ftruncate(file_, 0) != 0 || write(file_, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
      throw FileError(lock + ": cannot be written");
  } catch (...) {
    close(file_);
    throw;
  }
}

ResultsFolder::~ResultsFolder() { close(file_); }

}  // namespace ixos
