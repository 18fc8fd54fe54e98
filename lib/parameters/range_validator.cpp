#include "parameters/range_validator.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterEntry.hpp>
#include <cmath>
#include <ostream>
#include <vector>

#include "base/error.hpp"

namespace ixos {
namespace {

/// Returns the numbers in an entry; empty if it holds none.
std::vector<double> numbers(const Teuchos::ParameterEntry& entry) {
  std::vector<double> values;
  if (entry.isType<double>()) values.push_back(Teuchos::getValue<double>(entry));
  if (entry.isType<int>()) values.push_back(Teuchos::getValue<int>(entry));
  if (entry.isType<Teuchos::Array<double>>())
    for (double value : Teuchos::getValue<Teuchos::Array<double>>(entry)) values.push_back(value);
  if (entry.isType<Teuchos::Array<int>>())
    for (int value : Teuchos::getValue<Teuchos::Array<int>>(entry)) values.push_back(value);
  return values;
}

using End = RangeValidator::End;

Teuchos::RCP<const RangeValidator> make(double lower, End lower_end, double upper, End upper_end) {
  return Teuchos::rcp(new RangeValidator(lower, lower_end, upper, upper_end));
}

}  // namespace

std::string RangeValidator::words() const {
  std::string text;
  if (lower_ > -infinity) text = fmt::format("{} {}", lower_end_ == End::Open ? "greater than" : "at least", lower_);
  if (upper_ < infinity)
    text +=
        fmt::format("{}{} {}", text.empty() ? "" : " and ", upper_end_ == End::Open ? "less than" : "at most", upper_);
  return text.empty() ? "finite" : text;
}

bool RangeValidator::contains(double value) const {
  return std::isfinite(value) && (lower_end_ == End::Open ? value > lower_ : value >= lower_) &&
         (upper_end_ == End::Open ? value < upper_ : value <= upper_);
}

void RangeValidator::printDoc(const std::string& documentation, std::ostream& out) const {
  out << documentation << "Allowed: " << words() << '\n';
}

void RangeValidator::validate(const Teuchos::ParameterEntry& entry, const std::string&, const std::string&) const {
  for (double value : numbers(entry))
    if (!contains(value)) throw InputError(fmt::format("{} is not allowed: it must be {}", value, words()));
}

Teuchos::RCP<const RangeValidator> any_number() {
  return make(-RangeValidator::infinity, End::Closed, RangeValidator::infinity, End::Closed);
}
Teuchos::RCP<const RangeValidator> greater_than(double lower) {
  return make(lower, End::Open, RangeValidator::infinity, End::Closed);
}
Teuchos::RCP<const RangeValidator> at_least(double lower) {
  return make(lower, End::Closed, RangeValidator::infinity, End::Closed);
}
Teuchos::RCP<const RangeValidator> at_least_and_less_than(double lower, double upper) {
  return make(lower, End::Closed, upper, End::Open);
}
Teuchos::RCP<const RangeValidator> greater_than_and_at_most(double lower, double upper) {
  return make(lower, End::Open, upper, End::Closed);
}
Teuchos::RCP<const RangeValidator> greater_and_less_than(double lower, double upper) {
  return make(lower, End::Open, upper, End::Open);
}
Teuchos::RCP<const RangeValidator> between(double lower, double upper) {
  return make(lower, End::Closed, upper, End::Closed);
}

}  // namespace ixos
