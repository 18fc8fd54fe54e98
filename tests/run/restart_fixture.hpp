/// A run with every kind of force, gone on with from its checkpoints.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "run/checkpoints.hpp"
#include "run/run.hpp"
#include "support/files.hpp"
#include "support/scene_text.hpp"

namespace ixos::test {

namespace fs = std::filesystem;

/// A block that is drawn down to a sticky wall by one side, under a load and damped: every kind of force and sum.
inline std::string drawn(const std::string& integrator, const std::string& output = "", const std::string& more = "") {
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + counts("Divisions", {6, 3}))) +
         list("Materials", list("Rubber", number("Density", 1) + number("Mass Damping", 0.1))) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.9}))) +
         list("Histories",
              list("Down", word("Type", "Sine") + list("Sine", number("Offset", 0) + number("Amplitude", -0.5) +
                                                                   number("Frequency", 0.25)))) +
         list("Boundary Conditions",
              list("Grip", word("Node Set", "left") + word("Components", "y") + word("History", "Down")) +
                  list("Pull", word("Type", "Traction") + word("Side Set", "right") + numbers("Vector", {0.02, 0}))) +
         list("Initial Conditions", numbers("Velocity", {0.1, 0})) +
         list("Output", output + list("Probes", list("Edge", numbers("Point", {2, 0}))) +
                            "<Parameter name=\"Reactions\" type=\"Array(string)\" value=\"{left}\"/>") +
         list("Time Integrator", integrator) + more;
}

inline std::string steps(double step, double final_time, const std::string& more = "") {
  return list("Time Step Control", number("Time Step", step) + number("Final Time", final_time) + more);
}

inline std::string checkpoints(int interval, int keep) {
  return list("Checkpoint", count("Interval", interval) + count("Keep", keep));
}

/// A block that a history "Up" lifts off its wall as a whole.
inline std::string lifted(const std::string& integrator, const std::string& output) {
  const std::string lift = word("Components", "y") + word("History", "Up");
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 0.25}) + counts("Divisions", {16, 2}))) +
         list("Materials", list("Rubber", number("Density", 1))) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.26}))) +
         list("Histories", list("Up", word("Type", "Ramp") + list("Ramp", number("Value", 3) + number("Length", 1)))) +
         list("Boundary Conditions", list("Bottom", word("Node Set", "bottom") + lift) +
                                         list("Top", word("Node Set", "top") + lift) +
                                         list("Guide", word("Node Set", "left") + word("Components", "x"))) +
         list("Output", output) + list("Time Integrator", integrator);
}

class RestartTest : public testing::Test {
 protected:
  void SetUp() override {
    on_first([&] { fs::remove_all(folder_); });
  }
  void TearDown() override {
    on_first([&] { fs::remove_all(folder_); });
  }

  template <class Function>
  static void on_first(const Function& function) {
    world()->barrier();
    if (world()->getRank() == 0) function();
    world()->barrier();
  }
  std::string folder(const std::string& name) const { return folder_ + "/" + name; }
  std::string checkpoint(const std::string& name, long step) const { return checkpoint_path(folder(name), step); }

  RunResult run_scene(const std::string& scene, const std::string& name, const std::string& restart = "",
                      const std::function<bool()>& interrupted = {}) {
    const std::unique_ptr<Simulation> own = mesh_ ? std::make_unique<Simulation>(test::scene(scene), *mesh_, world())
                                                  : std::make_unique<Simulation>(test::scene(scene), world());
    Simulation& simulation = *own;
    RunOptions options;
    options.folder = folder(name);
    options.restart = restart;
    options.overwrite = true;  // one test runs several scenes into a folder
    options.interrupted = interrupted;
    options.log = [this](const std::string& line) { told_ += line + "\n"; };
    options.warn = [this](const std::string& line) { warned_ += line + "\n"; };
    return run(simulation, options);
  }
  /// A copy of a run's folder, with its checkpoints.
  void copy(const std::string& from, const std::string& to) {
    on_first([&] {
      fs::remove_all(folder(to));
      fs::copy(folder(from), folder(to), fs::copy_options::recursive | fs::copy_options::copy_symlinks);
    });
  }
  /// Compares the histories, and the fields: there must be some if they are expected, else none.
  void expect_same(const std::string& one, const std::string& other, bool fields_expected = false) {
    world()->barrier();
    EXPECT_EQ(history_rows(folder(one)), history_rows(folder(other)));
    std::set<std::string> fields[2];
    for (const std::string& name : {one, other})
      for (const auto& entry : fs::directory_iterator(folder(name)))
        if (const std::string file = entry.path().filename(); file.rfind("fields", 0) == 0)
          fields[name == one ? 0 : 1].insert(file);
    EXPECT_EQ(fields[0], fields[1]);
    EXPECT_EQ(!fields[0].empty(), fields_expected);
    for (const std::string& file : fields[0])
      EXPECT_TRUE(contents(folder(one) + "/" + file) == contents(folder(other) + "/" + file)) << file;
    world()->barrier();
  }
  /// Runs to the end; then from some of the checkpoints again: the same files must come out. Returns the first run's
  /// result.
  RunResult expect_goes_on(const std::string& scene, const std::vector<long>& from) {
    const bool fields_expected = scene.find("\"Fields ") != std::string::npos;
    RunResult whole = run_scene(scene, "whole");
    EXPECT_EQ(whole.status, RunStatus::Completed) << whole.reason;
    if (whole.status != RunStatus::Completed) return whole;
    for (const long step : from) {
      copy("whole", "again");
      const RunResult again = run_scene(scene, "again", checkpoint("again", step));
      expect_same("whole", "again", fields_expected);
      EXPECT_EQ(again.steps, whole.steps);
      EXPECT_EQ(again.rejected_steps, whole.rejected_steps);
      EXPECT_EQ(again.newton_iterations, whole.newton_iterations);
      EXPECT_EQ(again.max_energy_error, whole.max_energy_error);
      EXPECT_EQ(again.max_forces, whole.max_forces);
      EXPECT_EQ(again.restarts, 1);
    }
    return whole;
  }
  std::map<std::string, std::string> all_files(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder(name)))
      files[entry.path().filename()] = contents(entry.path());
    return files;
  }
  /// The message of the InputError that going on throws, without the rest having changed.
  std::string refusal(const std::string& scene, const std::string& name, const std::string& restart) {
    world()->barrier();
    const auto before = all_files(name);
    world()->barrier();
    std::string message;
    try {
      run_scene(scene, name, restart);
      ADD_FAILURE() << "it was not refused";
    } catch (const InputError& error) {
      message = error.what();
    }
    world()->barrier();
    EXPECT_TRUE(all_files(name) == before) << "something was changed";
    return message;
  }

  std::string folder_ = testing::TempDir() + "restart";
  std::optional<Mesh> mesh_;  ///< a program's, in place of that of the scenes
  std::string told_, warned_;
};

}  // namespace ixos::test
