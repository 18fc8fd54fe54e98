#include "scene/restart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/agreement.hpp"
#include "checkpoint/seal.hpp"
#include "scene/checkpoints.hpp"
#include "scene/scene_changes.hpp"
#include "scene/scene_file.hpp"

namespace ixos {
namespace {

namespace fs = std::filesystem;

/// The newest sound checkpoint beside a bad one, as an offer; of those before it where its name says its step.
std::string offer(const std::string& bad) {
  const std::string folder = fs::path(bad).parent_path().string();
  std::vector<long> steps = checkpoint_steps(folder);
  const auto own = std::find_if(steps.begin(), steps.end(), [&](long step) {
    return fs::path(checkpoint_path(folder, step)).filename() == fs::path(bad).filename();
  });
  steps.erase(own, steps.end());
  for (auto step = steps.rbegin(); step != steps.rend(); ++step)
    if (const std::string path = checkpoint_path(folder, *step); seal_problem(path).empty())
      return "; the one before it is sound: " + path;
  return "; there is no sound one before it";
}

}  // namespace

Restart::Restart(const Simulation& simulation, const std::string& path) {
  const Model& model = simulation.model();
  together<InputError>(model.space().comm(), [&] {
    std::error_code code;
    path_ = fs::canonical(path, code).string();
    if (code) {
      // A link may point at what is gone.
      const fs::path target = fs::is_symlink(path) ? fs::path(path).parent_path() / fs::read_symlink(path) : fs::path(path);
      throw InputError(fmt::format("{}: cannot be read: {}{}", target.string(), code.message(), offer(target.string())));
    }
    if (!fs::is_regular_file(path_)) throw InputError(path_ + ": is not a file");
    if (model.space().comm()->getRank() != 0) return;
    const std::string problem = seal_problem(path_);
    if (!problem.empty()) throw InputError(path_ + ": " + problem + offer(path_));
  });
  reader_ = std::make_unique<CheckpointReader>(path_, model.space(), model.mesh());
  std::string mesh, version;
  reader_->text("mesh", mesh);
  if (mesh != simulation.mesh_fingerprint())
    throw InputError(path_ + ": was written of another mesh than the scene's");
  compare_scenes(simulation);
  reader_->text("version", version);
  if (version != IXOS_VERSION)
    notes_.push_back(fmt::format("It was written by version {}, this is {}: not bit for bit.", version, IXOS_VERSION));
  if (reader_->same_scene() && !reader_->exact())
    notes_.push_back(fmt::format("It was written on {} rank(s), this run has {}: to solver tolerance, not bit for bit.",
                                 reader_->ranks(), model.space().comm()->getSize()));
}

void Restart::compare_scenes(const Simulation& simulation) {
  std::string text;
  reader_->text("scene", text);
  const auto before = read_scene_text(text, path_ + ": its scene");
  // As it would be read back, so that both are spelt alike.
  const auto now = read_scene_text(scene_text(simulation.parameters()), "the scene");
  std::string refused;
  bool same = true;
  for (const SceneChange& change : scene_changes(before, now)) {
    if (change.bearing == Bearing::State) refused += "\n  " + change.text();
    if (change.bearing == Bearing::Motion) same = false;
    notes_.push_back("Changed: " + change.text() + ".");
  }
  if (!refused.empty())
    throw InputError(path_ + ": was written of a scene that differs where a restart cannot change it:" + refused);
  reader_->set_same_scene(same);
  if (!same)
    notes_.emplace_back(
        "The run goes on from the same displacements and velocities; energies are still counted from the first row.");
}

bool Restart::is_in(const std::string& folder) const {
  std::error_code code;
  return fs::equivalent(fs::path(path_).parent_path(), folder, code) && !code;
}

}  // namespace ixos
