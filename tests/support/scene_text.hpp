/// Scenes for tests, written as XML text.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "base/tpetra.hpp"

namespace ixos::test {

/// The communicator of the test program, and one of this rank alone.
Comm world();
Comm self();

/// A scene from pieces: `lists` is the XML inside the outermost ParameterList.
Teuchos::ParameterList scene(const std::string& lists);

/// The contents of xml/<name>, with assignments as on the command line.
Teuchos::ParameterList scene_file(const std::string& name, const std::vector<std::string>& assignments = {});

/// XML of a list and of parameters, to compose scenes from.
std::string list(const std::string& name, const std::string& contents);
std::string number(const std::string& name, double value);
std::string count(const std::string& name, int value);
std::string word(const std::string& name, const std::string& value);
std::string numbers(const std::string& name, const std::vector<double>& values);
std::string counts(const std::string& name, const std::vector<int>& values);
/// `values`: "{a, b}".
std::string texts(const std::string& name, const std::string& values);

/// A list of "Histories" with an Expression in t; a load needs the value only.
std::string expression(const std::string& name, const std::string& value, const std::string& rate = "",
                       const std::string& acceleration = "");

/// "Time Integrator" with this scheme, its parameters, and fixed steps.
std::string time_integrator(const std::string& scheme, double step, double final_time,
                            const std::string& scheme_parameters = "");

}  // namespace ixos::test
