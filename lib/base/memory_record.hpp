/// A record in the memory of the process.
#pragma once
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/record.hpp"

namespace ixos {

/// A value that a record keeps.
struct KeptValue {
  double number = 0;
  std::string text;
  std::vector<double> numbers;
  long saved = 0;  ///< the number of the saving that named it
};

/// Keeps values by path: sections make paths of names. Ranks keep their own.
class MemoryRecord : public Record {
 public:
  using Values = std::map<std::string, KeptValue>;

  /// `saving`: a number that marks the values that are named, or 0 to load. The values must outlive the record.
  MemoryRecord(Values& values, long saving) : values_(values), saving_(saving) {}

  bool loading() const override { return saving_ == 0; }
  bool has_section(const std::string& name) const override {
    const std::string path = path_ + name + '/';
    const auto next = values_.lower_bound(path);
    return !loading() || (next != values_.end() && next->first.rfind(path, 0) == 0);
  }
  void text(const char* name, std::string& value) override { hand_over(value, of(name).text); }
  void field(const char* name, std::vector<double>& values, Extent) override { hand_over(values, of(name).numbers); }
  void share(const char* name, std::vector<double>& values) override { hand_over(values, of(name).numbers); }

 protected:
  /// Throws std::logic_error if there is none to load.
  KeptValue& of(const char* name) {
    if (!loading()) {
      KeptValue& value = values_[path_ + name];
      value.saved = saving_;
      return value;
    }
    const auto found = values_.find(path_ + name);
    if (found == values_.end()) throw std::logic_error("the record has no \"" + path_ + name + "\"");
    return found->second;
  }

 private:
  void scalar(const char* name, double& value) override { hand_over(value, of(name).number); }
  void enter(const std::string& name) override {
    lengths_.push_back(path_.size());
    path_ += name + '/';
  }
  void leave() override {
    path_.resize(lengths_.back());
    lengths_.pop_back();
  }
  template <class T>
  void hand_over(T& here, T& kept) const {
    if (loading())
      here = kept;
    else
      kept = here;
  }

  Values& values_;
  long saving_;
  std::string path_;
  std::vector<std::size_t> lengths_;  ///< of the paths of the outer sections
};

}  // namespace ixos
