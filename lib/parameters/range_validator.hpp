/// Numbers in an interval, for Teuchos parameter lists.
#pragma once
#include <Teuchos_ParameterEntryValidator.hpp>
#include <limits>
#include <string>

namespace ixos {

/// A validator that accepts an int or a double, or an array of either, if every element is finite and in the interval.
/// Unlike Teuchos' own number validators it knows open ends and refuses NaN; its message is one line.
class RangeValidator final : public Teuchos::ParameterEntryValidator {
 public:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  enum class End { Open, Closed };

  RangeValidator(double lower, End lower_end, double upper, End upper_end)
      : lower_(lower), upper_(upper), lower_end_(lower_end), upper_end_(upper_end) {}

  /// Returns the interval in words: "greater than 0", "at least 0 and less than 0.5", "finite".
  std::string words() const;
  bool contains(double value) const;

  const std::string getXMLTypeName() const override { return "IxosRange"; }
  void printDoc(const std::string& documentation, std::ostream& out) const override;
  ValidStringsList validStringValues() const override { return Teuchos::null; }
  /// Throws InputError with the value and the interval.
  void validate(const Teuchos::ParameterEntry& entry, const std::string& name, const std::string& list) const override;

 private:
  double lower_, upper_;
  End lower_end_, upper_end_;
};

Teuchos::RCP<const RangeValidator> any_number();
Teuchos::RCP<const RangeValidator> greater_than(double lower);
Teuchos::RCP<const RangeValidator> at_least(double lower);
Teuchos::RCP<const RangeValidator> at_least_and_less_than(double lower, double upper);
Teuchos::RCP<const RangeValidator> greater_than_and_at_most(double lower, double upper);
Teuchos::RCP<const RangeValidator> greater_and_less_than(double lower, double upper);
Teuchos::RCP<const RangeValidator> between(double lower, double upper);  ///< ends included

}  // namespace ixos
