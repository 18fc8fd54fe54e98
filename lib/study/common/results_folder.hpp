/// The results folder of a study.
#pragma once
#include <string>

namespace ixos {

/// Holds a folder for one study and this process as long as it lives. The file "lock" in it names the study.
class ResultsFolder {
 public:
  /// `owner`: one line that names the study. Throws FileError if the folder cannot be written or another process holds
  /// it, and InputError if it holds the results of another study, unless `overwrite` is set.
  ResultsFolder(const std::string& folder, const std::string& owner, bool overwrite);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

 private:
  int file_;
};

}  // namespace ixos
