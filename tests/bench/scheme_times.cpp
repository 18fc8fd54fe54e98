// A scene timed side by side in one run: every dynamic scheme, repeats interleaved, medians reported.
//   scheme_times SCENE.xml END_TIME [REPEATS [LIST/NAME=VALUE...]]
// All schemes must reach END_TIME or stop as the scene says. Ratios are to Newmark, repeat by repeat.
#include <fmt/format.h>

#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "run/run.hpp"
#include "scene/parameters.hpp"
#include "scene/scene_file.hpp"
#include "time/catalogue.hpp"

namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Samples {
  std::vector<double> milliseconds_per_iteration, per_increment, ratio, increment_ratio;
  std::vector<std::array<double, ixos::phase_names.size()>> phases;
  double iterations_per_increment = 0;
  double iterations = 0;
};

std::vector<ixos::Scheme> dynamic_schemes() {
  std::vector<ixos::Scheme> schemes = ixos::schemes();
  const auto still = [](const ixos::Scheme& scheme) { return ixos::is_static(scheme.table(scheme.parameters)); };
  schemes.erase(std::remove_if(schemes.begin(), schemes.end(), still), schemes.end());
  return schemes;
}

ixos::RunResult run(const std::string& scene_path, const std::string& scheme, double end, const std::string& folder,
                    const std::vector<std::string>& assignments) {
  Teuchos::ParameterList scene = ixos::read_scene_file(scene_path);
  for (const std::string& assignment : assignments) ixos::set_parameter(scene, ixos::scene_parameters(), assignment);
  ixos::set_parameter(scene, ixos::scene_parameters(), "Time Integrator/Type=" + scheme);
  ixos::set_parameter(scene, ixos::scene_parameters(),
                      fmt::format("Time Integrator/Time Step Control/Final Time={}", end));
  ixos::Simulation simulation(scene, Tpetra::getDefaultComm());
  ixos::RunOptions options;
  options.folder = folder;
  options.overwrite = true;
  return ixos::run(simulation, options);
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  if (argc < 3) {
    fmt::print(stderr, "scheme_times SCENE.xml END_TIME [REPEATS [LIST/NAME=VALUE...]]\n");
    return 2;
  }
  const double end = std::stod(argv[2]);
  const int repeats = argc > 3 ? std::stoi(argv[3]) : 5;
  const std::vector<std::string> assignments(argv + std::min(argc, 4), argv + argc);
  const std::vector<ixos::Scheme> schemes = dynamic_schemes();
  const std::string folder = (std::filesystem::temp_directory_path() / "ixos-bench").string();

  std::map<std::string, Samples> samples;
  for (int repeat = -1; repeat < repeats; ++repeat) {  // the first round warms up
    double newmark = 0, newmark_increment = 0;
    for (const ixos::Scheme& scheme : schemes) {
      const ixos::RunResult result = run(argv[1], scheme.name, end, folder, assignments);
      if (result.status != ixos::RunStatus::Completed && result.status != ixos::RunStatus::Stopped) {
        fmt::print(stderr, "{} ended at {}: {}\n", scheme.name, result.end_time, result.reason);
        return 3;
      }
      const double each = 1e3 * result.wall_seconds / static_cast<double>(result.newton_iterations);
      const double increment = 1e3 * result.wall_seconds / static_cast<double>(result.steps);
      if (scheme.name == "Newmark") {
        newmark = each;
        newmark_increment = increment;
      }
      if (repeat < 0) continue;
      Samples& s = samples[scheme.name];
      s.milliseconds_per_iteration.push_back(each);
      s.per_increment.push_back(increment);
      s.ratio.push_back(each / newmark);
      s.increment_ratio.push_back(increment / newmark_increment);
      s.phases.push_back(result.phase_seconds);
      s.iterations = static_cast<double>(result.newton_iterations);
      s.iterations_per_increment = static_cast<double>(result.newton_iterations) / static_cast<double>(result.steps);
    }
  }
  std::filesystem::remove_all(folder);

  fmt::print(
      "| scheme | ms per Newton iteration | to Newmark | iterations an increment | ms an increment | to Newmark |\n");
  fmt::print("|---|---|---|---|---|---|\n");
  for (const ixos::Scheme& scheme : schemes) {
    const Samples& s = samples[scheme.name];
    if (s.iterations == 0) {  // explicit
      fmt::print("| {} | - | - | 0 | {:.4f} | {:.4f} |\n", scheme.name, median(s.per_increment),
                 median(s.increment_ratio));
      continue;
    }
    fmt::print("| {} | {:.4f} | {:.3f} | {:.2f} | {:.3f} | {:.3f} |\n", scheme.name,
               median(s.milliseconds_per_iteration), median(s.ratio), s.iterations_per_increment,
               median(s.per_increment), median(s.increment_ratio));
  }
  const Samples& composite = samples["Gautam-Sauer Composite"];
  fmt::print("\nMicroseconds of a composite Newton iteration, last repeat:");
  for (std::size_t i = 0; i < ixos::phase_names.size(); ++i)
    fmt::print(" {} {:.1f};", ixos::phase_names[i], 1e6 * composite.phases.back()[i] / composite.iterations);
  fmt::print(" the whole {:.1f}\n", 1e3 * composite.milliseconds_per_iteration.back());
  return 0;
}
