#include "base/snapshot.hpp"

#include <iterator>
#include <stdexcept>

namespace ixos {

/// The record of a snapshot. Sections make paths of names.
class Snapshot::Memory final : public Record {
 public:
  /// `save`: the number of the save(), or 0 to load.
  Memory(std::map<std::string, Value>& values, long save) : values_(values), save_(save), loading_(save == 0) {}

  bool loading() const override { return loading_; }
  bool same_scene() const override { return true; }
  bool same_solution() const override { return true; }
  bool same_partition() const override { return true; }
  bool in_memory() const override { return true; }
  bool has_section(const std::string& name) const override {
    const std::string path = path_ + name + '/';
    const auto next = values_.lower_bound(path);
    return !loading_ || (next != values_.end() && next->first.rfind(path, 0) == 0);
  }

  void text(const char* name, std::string& value) override { hand_over(value, of(name).text); }
  void field(const char* name, std::vector<double>& values, Extent) override { hand_over(values, of(name).numbers); }
  void share(const char* name, std::vector<double>& values) override { hand_over(values, of(name).numbers); }
  void all_shares(const char*, std::vector<double>&) override {
    throw std::logic_error("a snapshot has no shares of other ranks");
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

  Value& of(const char* name) {
    if (!loading_) {
      Value& value = values_[path_ + name];
      value.saved = save_;
      return value;
    }
    const auto found = values_.find(path_ + name);
    if (found == values_.end()) throw std::logic_error("the snapshot has no \"" + path_ + name + "\"");
    return found->second;
  }
  template <class T>
  void hand_over(T& here, T& kept) const {
    if (loading_)
      here = kept;
    else
      kept = here;
  }

  std::map<std::string, Value>& values_;
  long save_;
  bool loading_;
  std::string path_;
  std::vector<std::size_t> lengths_;  ///< of the paths of the outer sections
};

void Snapshot::save() {
  full_ = false;
  Memory memory(values_, ++saves_);
  transfer_(memory);
  for (auto value = values_.begin(); value != values_.end();)  // of earlier saves, which this one did not name
    value = value->second.saved == saves_ ? std::next(value) : values_.erase(value);
  full_ = true;
}

void Snapshot::restore() {
  if (!full_) throw std::logic_error("nothing was saved to restore");
  Memory memory(values_, 0);
  transfer_(memory);
}

double Snapshot::bytes() const {
  double sum = 0;
  for (const auto& [path, value] : values_)
    sum += static_cast<double>(sizeof(value) + value.text.size() + 8 * value.numbers.size());
  return sum;
}

}  // namespace ixos
