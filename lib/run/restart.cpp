#include "run/restart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/agreement.hpp"
#include "checkpoint/seal.hpp"
#include "run/checkpoints.hpp"
#include "run/mesh_follower.hpp"
#include "scene/read/obstacle_files.hpp"
#include "scene/scene_changes.hpp"
#include "scene/scene_file.hpp"

namespace ixos {
namespace {

namespace fs = std::filesystem;

/// The newest sound checkpoint of those steps, or nothing.
std::string newest_sound(const std::string& folder, const std::vector<long>& steps) {
  for (auto step = steps.rbegin(); step != steps.rend(); ++step)
    if (std::string path = checkpoint_path(folder, *step); seal_problem(path).empty()) return path;
  return "";
}

/// An offer to go with the refusal of a checkpoint: one before it where its name says its step, else any beside it.
std::string offer(const fs::path& bad) {
  const std::string folder = fs::absolute(bad).parent_path().string();
  std::vector<long> steps = checkpoint_steps(folder);
  const auto own = std::find_if(steps.begin(), steps.end(), [&](long step) {
    return fs::path(checkpoint_path(folder, step)).filename() == bad.filename();
  });
  steps.erase(own, steps.end());
  const std::string sound = newest_sound(folder, steps);
  return sound.empty() ? "; no earlier checkpoint is sound" : "; an earlier checkpoint is sound: " + sound;
}

/// The file behind a path; a link may point at what is gone.
fs::path resolved(const std::string& path) {
  std::error_code code;
  if (fs::is_directory(path, code)) {
    const std::string sound = newest_sound(path, checkpoint_steps(path));
    if (sound.empty()) throw InputError(path + ": the folder has no sound checkpoint");
    return fs::canonical(sound);
  }
  const fs::path target =
      fs::is_symlink(path, code) ? fs::path(path).parent_path() / fs::read_symlink(path) : fs::path(path);
  fs::path whole = fs::canonical(target, code);
  if (code) throw InputError(target.string() + ": cannot be read: " + code.message() + offer(target));
  if (!fs::is_regular_file(whole)) throw InputError(whole.string() + ": is not a file");
  return whole;
}

/// Returns the file behind a path. Throws InputError on all ranks if it is no sound checkpoint. One rank chooses: a
/// file that another one cannot read must not lead it to an older checkpoint. Collective.
std::string sound_checkpoint(const Comm& comm, const std::string& path) {
  std::string file;
  on_first_rank(comm, [&] {
    file = resolved(path).string();
    const std::string problem = seal_problem(file);
    if (!problem.empty()) throw InputError(file + ": " + problem + offer(file));
  });
  return from_first_rank(comm, file);
}

/// Returns the times at which the stages of a checkpoint after the first one began [T0].
std::vector<double> begins_of_stages(const std::string& path, std::size_t stages) {
  Hdf5Input file(path);
  std::vector<double> begins;
  if (!file.has_group("run")) return begins;
  file.enter("run");
  if (!file.has_group("stages")) return begins;
  file.enter("stages");
  const double ended = file.number("ended");
  if (!(ended >= 0 && ended < static_cast<double>(stages)))
    throw InputError(fmt::format("{}: was written in stage {:.0f}, but the scene has {}", path, ended + 1, stages));
  for (int k = 1; k <= static_cast<int>(ended); ++k) {
    file.enter(fmt::format("stage {}", k));
    begins.push_back(file.number("next begins"));
    file.leave();
  }
  return begins;
}

/// Returns the simulation of the stage in which a checkpoint was written; null if it is the first one.
std::shared_ptr<Simulation> stage_of_checkpoint(const Simulation& simulation, const std::string& path) {
  if (!simulation.stages().any()) return nullptr;
  const Comm& comm = simulation.model().space().comm();
  const std::string file = sound_checkpoint(comm, path);
  std::vector<double> begins;
  together<InputError>(comm, [&] { begins = begins_of_stages(file, simulation.stages().count()); });
  std::shared_ptr<Simulation> stage;
  for (std::size_t k = simulation.stage(); k < begins.size(); ++k)
    stage = (stage ? *stage : simulation).next_stage(begins[k]);
  return stage;
}

/// Returns the simulation on the mesh that a checkpoint was written with; null if it has it.
std::shared_ptr<Simulation> mesh_of_checkpoint(const Simulation& simulation, const std::string& path) {
  const Comm& comm = simulation.model().space().comm();
  const std::string file = sound_checkpoint(comm, path);
  CellSplits splits;
  together<InputError>(comm, [&] {
    Hdf5Input input(file);
    if (!input.has_group("run")) return;
    input.enter("run");
    if (!input.has_group(adaptation_section))
      throw InputError(file + ": its run had a mesh that stays, but that of the scene follows the front: Mesh/Adapt");
    input.enter(adaptation_section);
    splits = CellSplits::of_text(input.text(splits_name));
  });
  if (splits == simulation.split_mesh().tree().splits()) return nullptr;
  std::shared_ptr<Simulation> other;
  try {
    other = simulation.on_mesh(splits);
  } catch (const InputError& error) {
    throw InputError(file + ": its mesh cannot be made of the scene's: " + error.what());
  }
  return other;
}

}  // namespace

Restart::Restart(const Simulation& simulation, const std::string& path) {
  const Model& model = simulation.model();
  path_ = sound_checkpoint(model.space().comm(), path);
  together<InputError>(model.space().comm(), [&] { compare_scenes(simulation); });
  reader_ = std::make_unique<CheckpointReader>(path_, model.space(), model.mesh());
  reader_->set_same(same_scene_, same_solution_);
  note_differences(simulation);
}

void Restart::compare_scenes(const Simulation& simulation) {
  const Hdf5Input file(path_);
  // A parameter that came after the version that wrote the checkpoint is no change.
  const auto before = with_defaults(read_scene_text(file.text("scene"), path_ + ": its scene"));
  // As it would be read back, so that both are spelt alike.
  const auto now = read_scene_text(scene_text(simulation.parameters()), "the scene");
  std::string refused, mesh;
  for (const SceneChange& change : scene_changes(before, now)) {
    if (change.bearing == Bearing::State) refused += "\n  " + change.text();
    if (change.path.rfind("Mesh/", 0) == 0 || change.path.rfind("Interactions/", 0) == 0)
      mesh += "\n  " + change.text();
    if (change.bearing == Bearing::Motion) same_scene_ = false;
    if (change.bearing == Bearing::Solution) same_solution_ = false;
    notes_.push_back("Changed: " + change.text() + ".");
  }
  if (file.text("mesh") != simulation.mesh_fingerprint())
    throw InputError(path_ + ": belongs to another mesh than the scene's" +
                     (obstacle_file_checksums(simulation.parameters()).empty()
                          ? ""
                          : ", or the files of its obstacles have changed") +
                     mesh);
  if (!refused.empty())
    throw InputError(path_ + ": belongs to a scene that differs in what a restart cannot change:" + refused);
}

void Restart::note_differences(const Simulation& simulation) {
  const std::string build = other_build(*reader_);
  if (!build.empty()) notes_.push_back(build);
  if (!reader_->same_partition())
    notes_.push_back(reader_->ranks() == simulation.model().space().comm()->getSize()
                         ? "It was written with the nodes distributed or ordered otherwise."
                         : fmt::format("It was written on {} rank(s), this run has {}.", reader_->ranks(),
                                       simulation.model().space().comm()->getSize()));
  if (!same_scene_)
    notes_.emplace_back(
        "The run resumes from the same displacements and velocities. Energy errors still refer to the first row.");
  else if (!reader_->exact() || !build.empty())
    notes_.emplace_back("The run resumes to solver tolerance, not bit for bit.");
}

void Restart::load(const std::function<void(Record&)>& transfer) {
  load_placed(path_, [&] { transfer(*reader_); });
}

std::shared_ptr<Simulation> simulation_of_checkpoint(const Simulation& simulation, const std::string& path) {
  std::shared_ptr<Simulation> stage = stage_of_checkpoint(simulation, path);
  if (!simulation.adaptation().on()) return stage;
  std::shared_ptr<Simulation> on_its_mesh = mesh_of_checkpoint(stage ? *stage : simulation, path);
  return on_its_mesh ? on_its_mesh : stage;
}

bool Restart::is_in(const std::string& folder) const {
  std::error_code code;
  return fs::equivalent(fs::path(path_).parent_path(), folder, code) && !code;
}

}  // namespace ixos
