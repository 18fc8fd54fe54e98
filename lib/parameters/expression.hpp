/// Formulas that a user writes.
#pragma once
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace ixos {

/// A muParser expression in some variables, with the constants _pi and _e. Evaluation stores the variables in the
/// object: use it from one thread at a time.
class Expression {
 public:
  /// `name`: what it is, for messages. Throws InputError, quoting the expression and muParser's message (positions
  /// count from 0), for one that is malformed, uses an unknown name, assigns, or is several separated by commas.
  Expression(const std::string& name, const std::string& text, const std::vector<std::string>& variables);
  ~Expression();
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;

  /// Returns the value for these values of the variables, in their order; NaN if it is not defined there. Never throws.
  double at(std::initializer_list<double> values) const;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace ixos
