#include <fmt/format.h>
#include <muParser.h>

#include <cmath>
#include <cstddef>

#include "base/error.hpp"
#include "histories/catalogue.hpp"
#include "parameters/validation.hpp"

namespace ixos {
namespace {

/// muParser would assign to t. Comparisons stay.
bool assigns(const std::string& text) {
  for (std::size_t i = text.find('='); i != std::string::npos; i = text.find('=', i + 1)) {
    if (i + 1 < text.size() && text[i + 1] == '=')
      ++i;
    else if (i == 0 || std::string("<>!").find(text[i - 1]) == std::string::npos)
      return true;
  }
  return false;
}

/// One expression in t. muParser evaluates from a variable in memory and compiles on first use: neither is const.
class Expression {
 public:
  /// `name` appears in messages.
  Expression(const std::string& name, const std::string& text) {
    const auto refuse = [&](const std::string& why) {
      throw InputError(fmt::format("the {} \"{}\" is not an expression in t: {}", name, text, why));
    };
    if (assigns(text)) refuse("it assigns with =");
    try {
      parser_.DefineVar("t", &time_);
      parser_.DefineConst("_pi", M_PI);  // that of muParser 2.3.3 has 12 decimals
      parser_.SetExpr(text);
      parser_.Eval();
    } catch (const mu::ParserError& error) {
      const bool placed = error.GetPos() < 0 || error.GetMsg().find("position") != std::string::npos;
      refuse(error.GetMsg() + (placed ? "" : fmt::format(" At position {}.", error.GetPos())));
    }
    if (parser_.GetNumResults() != 1) refuse("it contains several expressions, separated by commas");
  }
  Expression(const Expression&) = delete;  // the parser points to time_
  Expression& operator=(const Expression&) = delete;

  double at(double time) const {
    time_ = time;
    try {
      return parser_.Eval();
    } catch (const mu::ParserError&) {  // muParser can be built to throw where a function is not defined
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

 private:
  mutable double time_ = 0;
  mu::Parser parser_;
};

class Expressions final : public TimeFunction {
 public:
  Expressions(const std::string& value, const std::string& rate, const std::string& acceleration,
              const ExpressionUnits& units)
      : value_("value", value), units_(units) {
    if (!rate.empty()) rate_ = std::make_unique<Expression>("rate", rate);
    if (!acceleration.empty()) acceleration_ = std::make_unique<Expression>("acceleration", acceleration);
  }

  TimeValue at(double time) const override {
    const double t = time / units_.time, unit = units_.value;
    return {value_.at(t) * unit, (rate_ ? rate_->at(t) : 0) * unit / units_.time,
            (acceleration_ ? acceleration_->at(t) : 0) * unit / (units_.time * units_.time)};
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
           "Expression of the first derivative of Velocity. A motion needs it; Ixos verifies it by quadrature.")
      .add("Time Unit", &Parameters::time_unit, "Unit of t in the expressions [T0].", greater_than(0))
      .add("Value Unit", &Parameters::value_unit,
           "Unit of the value that the expressions give [L0 for a motion, - for a load]; that of Velocity is Value "
           "Unit over Time Unit, and so on.",
           greater_than(0));
  return {"Expression", "muParser expressions in the time t.", "", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            return expression(p.value, p.velocity, p.acceleration, {p.time_unit, p.value_unit});
          }};
}

}  // namespace ixos
