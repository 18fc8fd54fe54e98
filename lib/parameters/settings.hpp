/// Settings that a program passes in code, without a parameter list.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ixos {

/// The name of a parameter, as in scenes, and its value: {"Gamma L", 2.5}, {"Constants", "Hamaker"},
/// {"Center", {0.0, -3.0}}.
struct Setting {
  Setting(std::string parameter, double number) : name(std::move(parameter)), value(number) {}
  Setting(std::string parameter, bool choice) : name(std::move(parameter)), value(choice) {}
  Setting(std::string parameter, int number) : name(std::move(parameter)), value(number) {}
  Setting(std::string parameter, const char* word) : name(std::move(parameter)), value(std::string(word)) {}
  Setting(std::string parameter, std::vector<double> numbers) : name(std::move(parameter)), value(std::move(numbers)) {}

  std::string name;
  std::variant<double, bool, int, std::string, std::vector<double>> value;
};

using Settings = std::vector<Setting>;

/// Adds the settings to a list.
void set(Teuchos::ParameterList& list, const Settings& settings);

}  // namespace ixos
