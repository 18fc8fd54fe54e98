#include "parameters/expression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/error.hpp"

namespace ixos {
namespace {

/// muParser would assign to a variable. Comparisons stay.
bool assigns(const std::string& text) {
  for (std::size_t i = text.find('='); i != std::string::npos; i = text.find('=', i + 1)) {
    if (i + 1 < text.size() && text[i + 1] == '=')
      ++i;
    else if (i == 0 || std::string("<>!").find(text[i - 1]) == std::string::npos)
      return true;
  }
  return false;
}

}  // namespace

/// muParser evaluates from variables in memory and compiles on first use: neither is const.
struct Expression::Parser {
  std::vector<double> values;
  mu::Parser parser;
};

Expression::Expression(const std::string& name, const std::string& text, const std::vector<std::string>& variables)
    : parser_(std::make_unique<Parser>()) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(
        fmt::format("the {} \"{}\" is not an expression in {}: {}", name, text, fmt::join(variables, ", "), why));
  };
  if (assigns(text)) refuse("it assigns with =");
  mu::Parser& parser = parser_->parser;
  parser_->values.resize(variables.size());
  try {
    for (std::size_t i = 0; i < variables.size(); ++i) parser.DefineVar(variables[i], &parser_->values[i]);
    parser.DefineConst("_pi", M_PI);  // that of muParser 2.3.3 has 12 decimals
    parser.SetExpr(text);
    parser.Eval();
  } catch (const mu::ParserError& error) {
    const bool placed = error.GetPos() < 0 || error.GetMsg().find("position") != std::string::npos;
    refuse(error.GetMsg() + (placed ? "" : fmt::format(" At position {}.", error.GetPos())));
  }
  if (parser.GetNumResults() != 1) refuse("it contains several expressions, separated by commas");
}

Expression::~Expression() = default;

double Expression::at(std::initializer_list<double> values) const {
  std::copy(values.begin(), values.end(), parser_->values.begin());
  try {
    return parser_->parser.Eval();
  } catch (const mu::ParserError&) {  // muParser can be built to throw where a function is not defined
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace ixos
