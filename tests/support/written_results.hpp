/// Results folders of runs that never were.
#pragma once
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ixos::test {

/// A column of history.csv as a function of time.
using WrittenColumn = std::pair<std::string, std::function<double(double)>>;

/// Writes history.csv with rows at 0, dt, ..., end, summary.json with an energy error, and effective.xml of a scheme.
inline void write_results(const std::string& folder, const std::string& scheme, double dt, double end,
                          const std::vector<WrittenColumn>& columns, double energy_error = 0) {
  std::filesystem::create_directories(folder);
  std::ofstream history(folder + "/history.csv");
  history.precision(17);
  history << "step,time,time_step";
  for (const WrittenColumn& column : columns) history << ',' << column.first;
  history << '\n';
  for (int n = 0; n * dt <= end * (1 + 1e-12); ++n) {
    history << n << ',' << n * dt << ',' << dt;
    for (const WrittenColumn& column : columns) history << ',' << column.second(n * dt);
    history << '\n';
  }
  std::ofstream(folder + "/summary.json") << "{\"max_energy_error\": " << energy_error << "}";
  std::ofstream(folder + "/effective.xml")
      << "<ParameterList name=\"x\"><ParameterList name=\"Time Integrator\"><Parameter name=\"Type\" type=\"string\" "
         "value=\""
      << scheme << "\"/><ParameterList name=\"" << scheme << "\"/></ParameterList></ParameterList>";
}

}  // namespace ixos::test
