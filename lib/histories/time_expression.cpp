#include <memory>

#include "histories/catalogue.hpp"
#include "parameters/expression.hpp"
#include "parameters/validation.hpp"

namespace ixos {
namespace {

class Expressions final : public TimeFunction {
 public:
  Expressions(const std::string& value, const std::string& rate, const std::string& acceleration,
              const ExpressionUnits& units)
      : value_("value", value, {"t"}), units_(units) {
    const std::vector<std::string> names = {"t"};
    if (!rate.empty()) rate_ = std::make_unique<Expression>("rate", rate, names);
    if (!acceleration.empty()) acceleration_ = std::make_unique<Expression>("acceleration", acceleration, names);
  }

  TimeValue at(double time) const override {
    const double t = time / units_.time, unit = units_.value;
    return {value_.at({t}) * unit, (rate_ ? rate_->at({t}) : 0) * unit / units_.time,
            (acceleration_ ? acceleration_->at({t}) : 0) * unit / (units_.time * units_.time)};
  }

 private:
  Expression value_;
  std::unique_ptr<Expression> rate_, acceleration_;
  ExpressionUnits units_;
};

struct Parameters {
  std::string value = required, velocity, acceleration;
  double time_unit = 1, value_unit = 1;
};

}  // namespace

std::shared_ptr<const TimeFunction> expression(const std::string& value, const std::string& rate,
                                               const std::string& acceleration, const ExpressionUnits& units) {
  return std::make_shared<Expressions>(value, rate, acceleration, units);
}

HistoryEntry expression_history() {
  Options<Parameters> options;
  options.add("Value", &Parameters::value, history_value("Expression of the value"))
      .add("Velocity", &Parameters::velocity,
           "Expression of the first derivative of Value. A motion needs it; Ixos verifies it by quadrature.")
      .add("Acceleration", &Parameters::acceleration,
           "Expression of the first derivative of Velocity. A motion needs it; Ixos verifies it by quadrature, unless "
           "the scheme is Static.")
      .add("Time Unit", &Parameters::time_unit, "Unit of t in the expressions [T0].", greater_than(0))
      .add("Value Unit", &Parameters::value_unit,
           "Unit of the value that the expressions give [L0 for a motion, - for a load, rad for an angle]; that of "
           "Velocity is Value "
           "Unit over Time Unit, and so on.",
           greater_than(0));
  return {"Expression", "muParser expressions in the time t.", "", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            return expression(p.value, p.velocity, p.acceleration, {p.time_unit, p.value_unit});
          }};
}

}  // namespace ixos
