#include "parameters/parameter_text.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <sstream>
#include <vector>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "base/text.hpp"
#include "units/quantity.hpp"

namespace ixos {
namespace {

constexpr std::size_t longest_name = 255;

const std::vector<std::string> type_names{"double",        "int",        "bool",         "string",
                                          "Array(double)", "Array(int)", "Array(string)"};

[[noreturn]] void refuse(const std::string& text, const std::string& type) {
  throw InputError("\"" + text + "\" is not of type " + type);
}

/// Returns the number that the whole text spells, or nothing.
template <class Number>
std::optional<Number> plain_number(const std::string& text) {
  std::string digits = trimmed(text);
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.erase(0, 1);
  Number value{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

template <class Number>
Number number(const std::string& text, const std::string& type) {
  const std::optional<Number> value = plain_number<Number>(text);
  if (!value) refuse(text, type);
  return *value;
}

bool boolean(const std::string& text) {
  std::string word = trimmed(text);
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (word == "true" || word == "yes" || word == "1") return true;
  if (word == "false" || word == "no" || word == "0") return false;
  refuse(text, "bool (true or false)");
}

/// Returns the elements between the commas of a text; a comma between brackets separates none.
std::vector<std::string> elements(const std::string& text) {
  std::vector<std::string> result;
  for (const std::string& piece : split(text, ',')) {
    const bool is_open = !result.empty() && result.back().rfind('[') != std::string::npos &&
                         result.back().find(']', result.back().rfind('[')) == std::string::npos;
    if (is_open && piece.find(']') != std::string::npos)
      result.back() += ", " + piece;
    else
      result.push_back(piece);
  }
  return result;
}

/// Calls a function with each element between the braces of "{a, b}".
template <class Function>
void for_elements(const std::string& text, const std::string& type, const Function& function) {
  const std::string body = trimmed(text);
  if (body.size() < 2 || body.front() != '{' || body.back() != '}') refuse(text, type + ", as in {1, 2}");
  const std::string inside = trimmed(body.substr(1, body.size() - 2));
  if (inside.empty()) return;
  for (const std::string& element : elements(inside)) {
    if (element.empty()) refuse(text, type + ", as in {1, 2}: an element is empty");
    function(element);
  }
}

/// Sets a double; a number with a unit is kept as a string. Throws InputError.
void set_double(Teuchos::ParameterList& list, const std::string& name, const std::string& text) {
  if (const std::optional<double> value = plain_number<double>(text))
    list.set(name, *value);
  else if (begins_with_number(text) && parse_quantity(text).has_unit)
    list.set(name, trimmed(text));
  else
    refuse(text, "double");
}

/// Sets an array of doubles as set_double() sets one.
void set_doubles(Teuchos::ParameterList& list, const std::string& name, const std::string& text) {
  const std::string type = "Array(double)", body = trimmed(text);
  const auto end = body.find('}');
  bool plain = end + 1 == body.size(), numbers = true;
  Teuchos::Array<double> values;
  for_elements(end == std::string::npos ? body : body.substr(0, end + 1), type, [&](const std::string& element) {
    const std::optional<double> value = plain_number<double>(element);
    plain = plain && value;
    numbers = numbers && begins_with_number(element);
    if (!value && !numbers) refuse(element, "double");
    values.push_back(value.value_or(0));
  });
  if (plain) {
    list.set(name, values);
    return;
  }
  const std::vector<Quantity> quantities = parse_quantities(body);
  if (std::none_of(quantities.begin(), quantities.end(), [](const Quantity& q) { return q.has_unit; }))
    refuse(text, type + ", as in {1, 2} or {1, 2} nm");
  list.set(name, body);
}

const std::string& checked_string(const std::string& text) {
  if (const auto place = first_unfit_byte(text); place != std::string::npos)
    refuse(printable(text), fmt::format("string: byte {} is a control character, or not UTF-8", place + 1));
  return text;
}

}  // namespace

void check_name(const std::string& name) {
  if (name.size() > longest_name)
    throw InputError(fmt::format("\"{}...\" is not a valid name: it has {} bytes, at most {} are allowed",
                                 name.substr(0, 40), name.size(), longest_name));
  if (first_unfit_byte(name) != std::string::npos)
    throw InputError("\"" + printable(name) +
                     "\" is not a valid name: it contains a control character, or is not UTF-8");
  if (name.size() > 1 && name.front() == '<' && name.back() == '>')
    throw InputError("\"" + name + "\" is not a valid name: it must not be enclosed in angle brackets");
}

void set_from_text(Teuchos::ParameterList& list, const std::string& name, const std::string& type,
                   const std::string& text) {
  check_name(name);
  if (type == "double") {
    set_double(list, name, text);
  } else if (type == "int") {
    list.set(name, number<int>(text, type));
  } else if (type == "bool") {
    list.set(name, boolean(text));
  } else if (type == "string") {
    list.set(name, checked_string(text));
  } else if (type == "Array(double)") {
    set_doubles(list, name, text);
  } else if (type == "Array(int)") {
    Teuchos::Array<int> values;
    for_elements(text, type, [&](const std::string& element) { values.push_back(number<int>(element, "int")); });
    list.set(name, values);
  } else if (type == "Array(string)") {
    Teuchos::Array<std::string> values;
    for_elements(text, type, [&](const std::string& element) { values.push_back(checked_string(element)); });
    list.set(name, values);
  } else {
    throw InputError(no_such("type", type, type_names, "There are"));
  }
}

std::string type_name(const Teuchos::ParameterEntry& entry) {
  if (entry.isType<double>()) return "double";
  if (entry.isType<int>()) return "int";
  if (entry.isType<bool>()) return "bool";
  if (entry.isType<std::string>()) return "string";
  if (entry.isType<Teuchos::Array<double>>()) return "Array(double)";
  if (entry.isType<Teuchos::Array<int>>()) return "Array(int)";
  if (entry.isType<Teuchos::Array<std::string>>()) return "Array(string)";
  return "unknown";
}

std::string value_text(const Teuchos::ParameterEntry& entry) {
  if (entry.isType<bool>()) return Teuchos::getValue<bool>(entry) ? "true" : "false";
  std::ostringstream stream;
  stream << entry.getAny(false);
  return stream.str();
}

std::string short_text(const Teuchos::ParameterEntry& entry) {
  if (entry.isType<double>()) return fmt::format("{}", Teuchos::getValue<double>(entry));
  if (entry.isType<Teuchos::Array<double>>()) {
    std::string text;
    for (double value : Teuchos::getValue<Teuchos::Array<double>>(entry))
      text += (text.empty() ? "" : ", ") + fmt::format("{}", value);
    return "{" + text + "}";
  }
  return value_text(entry);
}

}  // namespace ixos
