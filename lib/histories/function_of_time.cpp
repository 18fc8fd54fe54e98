#include <utility>

#include "histories/time_function.hpp"

namespace ixos {
namespace {

class FunctionOfTime final : public TimeFunction {
 public:
  explicit FunctionOfTime(std::function<TimeValue(double)> f) : f_(std::move(f)) {}
  TimeValue at(double time) const override { return f_(time); }

 private:
  std::function<TimeValue(double)> f_;
};

}  // namespace

std::shared_ptr<const TimeFunction> function_of_time(std::function<TimeValue(double)> f) {
  return std::make_shared<FunctionOfTime>(std::move(f));
}

}  // namespace ixos
