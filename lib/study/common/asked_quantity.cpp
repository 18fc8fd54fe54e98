#include "study/common/asked_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "base/text.hpp"

namespace ixos {
namespace {

using Kind = AskedQuantity::Kind;

/// A form: the words before the column, whether there is a column, a word after it, and a number after that.
struct Form {
  Kind kind;
  const char* before;
  const char* column;  ///< of a user, a given one, or empty: none
  const char* after;   ///< before a number; empty: there is none
  bool window;
  const char* shown;
};

const char* const any_column = "COLUMN";

const std::vector<Form>& forms() {
  static const std::vector<Form> all{
      {Kind::PeakTime, "time of peak", any_column, "", true, "time of peak COLUMN"},
      {Kind::FirstContact, "time of first contact", "contact_measure", "", true, "time of first contact"},
      {Kind::Detachment, "time of detachment", "contact_measure", "", true, "time of detachment"},
      {Kind::Arrest, "time of arrest", "kinetic_energy", "", true, "time of arrest"},
      {Kind::TimeAbove, "time of", any_column, "above", true, "time of COLUMN above LIMIT"},
      {Kind::TimeBelow, "time of", any_column, "below", true, "time of COLUMN below LIMIT"},
      {Kind::Peak, "peak", any_column, "", true, "peak COLUMN"},
      {Kind::Maximum, "maximum", any_column, "", true, "maximum COLUMN"},
      {Kind::Minimum, "minimum", any_column, "", true, "minimum COLUMN"},
      {Kind::Mean, "mean", any_column, "", true, "mean COLUMN"},
      {Kind::Rms, "rms", any_column, "", true, "rms COLUMN"},
      {Kind::Final, "final", any_column, "", false, "final COLUMN"},
      {Kind::Value, "value", any_column, "at", false, "value COLUMN at TIME"},
      {Kind::Work, "work", "external_work", "", true, "work"},
      {Kind::EnergyError, "energy error", "kinetic_energy", "", false, "energy error"},
      {Kind::Restitution, "restitution", any_column, "", true, "restitution COLUMN"}};
  return all;
}

bool to_number(const std::string& text, double& number) {
  char* end = nullptr;
  number = std::strtod(text.c_str(), &end);
  return !text.empty() && end == text.c_str() + text.size() && std::isfinite(number);
}

/// Returns the text with one blank between words.
std::string single_spaced(const std::string& text) {
  std::string result;
  for (char c : trimmed(text)) {
    const char read = c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
    if (read != ' ' || result.empty() || result.back() != ' ') result += read;
  }
  return result;
}

/// Matches a text without its window with a form, and fills in the column and the number.
bool matches(const std::string& text, const Form& form, std::string& column, double& number) {
  const std::string before = form.before;
  column = form.column;
  if (column != any_column) return text == before;
  if (text.rfind(before + " ", 0) != 0) return false;
  column = text.substr(before.size() + 1);
  const std::string after = form.after;
  if (after.empty()) return true;
  const auto place = column.rfind(" " + after + " ");
  if (place == std::string::npos || !to_number(column.substr(place + after.size() + 2), number)) return false;
  column.resize(place);
  return true;
}

}  // namespace

std::string quantity_forms() {
  std::string text;
  for (const Form& form : forms()) text += std::string("  ") + form.shown + (form.window ? " [FROM, TO]" : "") + "\n";
  return text + "A window [FROM, TO] may be left out.\n";
}

AskedQuantity::AskedQuantity(const std::string& text) : text_(single_spaced(text)), kind_(Kind::Peak) {
  std::string head = text_;
  const auto bracket = head.rfind('[');
  const bool has_window = bracket != std::string::npos && head.back() == ']';
  if (has_window) {
    const std::vector<std::string> ends = split(head.substr(bracket + 1, head.size() - bracket - 2), ',');
    if (ends.size() != 2 || !to_number(ends[0], from_) || !to_number(ends[1], to_))
      refuse("the window must be two times, as in [20, 50]");
    if (!(from_ < to_)) refuse("the start of the window must be less than its end");
    head = trimmed(head.substr(0, bracket));
  }
  for (const Form& form : forms()) {
    if (!matches(head, form, column_, number_)) continue;
    if (has_window && !form.window) refuse("this quantity takes no window");
    kind_ = form.kind;
    return;
  }
  refuse("this is no quantity. Quantities are:\n" + quantity_forms());
}

AskedQuantity AskedQuantity::of_column(const std::string& column) const {
  AskedQuantity result = *this;
  if (const auto place = text_.find(column_); place != std::string::npos)
    result.text_.replace(place, column_.size(), column);
  result.column_ = column;
  return result;
}

bool AskedQuantity::is_proportional() const {
  switch (kind_) {
    case Kind::EnergyError:
    case Kind::Restitution:
    case Kind::PeakTime:
    case Kind::TimeAbove:
    case Kind::TimeBelow:
    case Kind::FirstContact:
    case Kind::Detachment:
    case Kind::Arrest:
      return false;
    default:
      return true;
  }
}

std::string AskedQuantity::column_of_unit() const {
  if (is_proportional()) return column_;
  return kind_ == Kind::EnergyError || kind_ == Kind::Restitution ? "" : "time";
}

void AskedQuantity::refuse(const std::string& why) const { throw InputError("\"" + text_ + "\": " + why); }

void AskedQuantity::check_columns(const std::vector<std::string>& names) const {
  if (std::find(names.begin(), names.end(), column_) != names.end()) return;
  if (column_.rfind("norm_", 0) == 0)
    refuse("column \"" + column_ + "\" does not exist; list the field in Output/Norms of the scene");
  refuse(no_such("column", column_, names, "The scene's history.csv has"));
}

void AskedQuantity::check_times(double from, double to) const {
  if (kind_ == Kind::Value && (number_ < from || number_ > to))
    refuse(fmt::format("the time {:.6g} is not within the run, from {:.6g} to {:.6g} T0", number_, from, to));
  if (std::isfinite(from_) && (from_ >= to || to_ <= from))
    refuse(fmt::format("the window holds no rows: the run is from {:.6g} to {:.6g} T0", from, to));
}

}  // namespace ixos
