#include "histories/catalogue.hpp"

namespace ixos {
namespace {

class Constant final : public TimeFunction {
 public:
  explicit Constant(double value) : value_(value) {}
  TimeValue at(double) const override { return {value_, 0, 0}; }

 private:
  double value_;
};

struct Parameters {
  double value = 1;
};

}  // namespace

std::shared_ptr<const TimeFunction> constant(double value) { return std::make_shared<Constant>(value); }

HistoryEntry constant_history() {
  Options<Parameters> options;
  options.add("Value", &Parameters::value, history_value("Value of the function"), any_number());
  return {"Constant", "A value that does not change over time.", "", options.list(),
          [options](const SceneNode& node) { return constant(options.read(node).value); }};
}

}  // namespace ixos
