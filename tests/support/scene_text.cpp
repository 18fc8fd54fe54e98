#include "support/scene_text.hpp"

#include <fmt/format.h>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>

#include "scene/read/parameters.hpp"
#include "scene/scene_file.hpp"
#include "test_folders.hpp"

namespace ixos::test {
namespace {

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return fmt::format("<Parameter name=\"{}\" type=\"{}\" value=\"{}\"/>", name, type, value);
}

template <class T>
std::string braces(const std::vector<T>& values) {
  std::string text;
  for (const T& value : values) text += (text.empty() ? "" : ", ") + fmt::format("{}", value);
  return "{" + text + "}";
}

}  // namespace

Comm world() { return Tpetra::getDefaultComm(); }
Comm self() { return Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF)); }

Teuchos::ParameterList scene(const std::string& lists) {
  return read_scene_text("<ParameterList name=\"Test\">" + lists + "</ParameterList>", "test scene");
}

Teuchos::ParameterList scene_file(const std::string& name, const std::vector<std::string>& assignments) {
  Teuchos::ParameterList result = read_scene_file(std::string(IXOS_XML_DIRECTORY) + "/" + name);
  for (const std::string& assignment : assignments) set_parameter(result, scene_parameters(), assignment);
  return result;
}

std::string list(const std::string& name, const std::string& contents) {
  return "<ParameterList name=\"" + name + "\">" + contents + "</ParameterList>";
}
std::string number(const std::string& name, double value) {
  return parameter(name, "double", fmt::format("{}", value));
}
std::string count(const std::string& name, int value) { return parameter(name, "int", fmt::format("{}", value)); }
std::string word(const std::string& name, const std::string& value) { return parameter(name, "string", value); }
std::string numbers(const std::string& name, const std::vector<double>& values) {
  return parameter(name, "Array(double)", braces(values));
}
std::string counts(const std::string& name, const std::vector<int>& values) {
  return parameter(name, "Array(int)", braces(values));
}
std::string texts(const std::string& name, const std::string& values) {
  return parameter(name, "Array(string)", values);
}

std::string expression(const std::string& name, const std::string& value, const std::string& rate,
                       const std::string& acceleration) {
  return list(name, word("Type", "Expression") + list("Expression", word("Value", value) + word("Velocity", rate) +
                                                                        word("Acceleration", acceleration)));
}

std::string time_integrator(const std::string& scheme, double step, double final_time,
                            const std::string& scheme_parameters) {
  return list("Time Integrator",
              word("Type", scheme) + (scheme_parameters.empty() ? "" : list(scheme, scheme_parameters)) +
                  list("Time Step Control", number("Time Step", step) + number("Final Time", final_time)));
}

}  // namespace ixos::test
