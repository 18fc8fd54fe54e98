#include "run/checkpoints.hpp"

#include <fmt/format.h>

#include <Teuchos_Time.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "base/agreement.hpp"
#include "base/pack.hpp"
#include "base/phase_timer.hpp"
#include "checkpoint/checkpoint_file.hpp"
#include "io/disk_file.hpp"
#include "scene/scene_file.hpp"

namespace ixos {
namespace {

namespace fs = std::filesystem;

const std::string prefix = "checkpoint-";
const std::string ending = ".h5";

/// The step that a file name speaks of, or -1.
long step_of(const std::string& name) {
  if (name.size() <= prefix.size() + ending.size() || name.rfind(prefix, 0) != 0 ||
      name.substr(name.size() - ending.size()) != ending)
    return -1;
  long step = -1;
  const char* end = name.data() + name.size() - ending.size();
  const auto [stop, error] = std::from_chars(name.data() + prefix.size(), end, step);
  return error == std::errc{} && stop == end ? step : -1;
}

/// Makes checkpoint.h5 a link to the newest. On a file system without links there is none.
void link_newest(const std::string& folder, long step) {
  const std::string link = folder + "/checkpoint" + ending;
  const std::string unfinished = beside(link);
  std::error_code code;
  fs::remove(unfinished, code);
  fs::create_symlink(prefix + std::to_string(step) + ending, unfinished, code);
  if (!code) return replace_file(unfinished, link);
  const bool without_links = code == std::errc::operation_not_permitted || code == std::errc::operation_not_supported ||
                             code == std::errc::function_not_supported;
  if (!without_links) throw FileError(link + ": cannot be written: " + code.message());
  fs::remove(link, code);
}

}  // namespace

std::string build_name() {
  return fmt::format("Ixos {}, {} doubles wide, compiler {}", IXOS_VERSION, pack_width, __VERSION__);
}

std::string other_build(Record& record) {
  std::string build;
  record.text("build", build);
  return build == build_name() ? "" : fmt::format("It was written by \"{}\", this is \"{}\".", build, build_name());
}

void load_placed(const std::string& path, const std::function<void()>& load) {
  try {
    load();
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.rfind(path, 0) == 0 ? what : path + ": " + what);
  }
}

void write_identity(Record& record, const Simulation& simulation) {
  std::string build = build_name(), scene = scene_text(simulation.parameters()), mesh = simulation.mesh_fingerprint();
  record.text("build", build);
  record.text("scene", scene);
  record.text("mesh", mesh);
}

std::vector<long> checkpoint_steps(const std::string& folder) {
  std::vector<long> steps;
  for (const std::string& name : names_in(folder))
    if (const long step = step_of(name); step >= 0) steps.push_back(step);
  std::sort(steps.begin(), steps.end());
  return steps;
}

std::string checkpoint_path(const std::string& folder, long step) {
  return (fs::path(folder) / (prefix + std::to_string(step) + ending)).string();
}

Checkpoints::Checkpoints(const Simulation& simulation, const std::string& folder)
    : simulation_(simulation),
      folder_(folder),
      options_(simulation.output().checkpoint),
      last_time_(Teuchos::Time::wallTime()) {}

bool Checkpoints::due_by_clock() const {
  return on() && options_.clock_interval > 0 && Teuchos::Time::wallTime() - last_time_ >= options_.clock_interval;
}

std::string Checkpoints::newest() const { return steps_.empty() ? "" : checkpoint_path(folder_, steps_.back()); }

long Checkpoints::begin(bool remove) {
  long newest = -1;
  on_first_rank(simulation_.model().space().comm(), [&] {
    std::error_code code;
    fs::remove(folder_ + "/checkpoint" + ending, code);
    for (const long step : checkpoint_steps(folder_)) {
      newest = remove ? -1 : step;
      if (remove && !fs::remove(checkpoint_path(folder_, step), code))
        throw FileError(checkpoint_path(folder_, step) + ": cannot be replaced: " + code.message());
    }
  });
  return newest;
}

void Checkpoints::go_on_from(const Checkpoints& before) {
  last_step_ = before.last_step_;
  last_time_ = before.last_time_;
  steps_ = before.steps_;
}

void Checkpoints::resume(long step) {
  const Comm& comm = simulation_.model().space().comm();
  std::string earlier;  // one rank looks: others may see the folder differently
  on_first_rank(comm, [&] {
    for (const long found : checkpoint_steps(folder_))
      if (found <= step) earlier += std::to_string(found) + ' ';
  });
  std::istringstream list(from_first_rank(comm, earlier));
  steps_.assign(std::istream_iterator<long>(list), {});
  last_step_ = std::count(steps_.begin(), steps_.end(), step) > 0 ? step : -1;
  // The results go on from there: those after it are of a history that is no more.
  on_first_rank(simulation_.model().space().comm(), [&] {
    if (fs::exists(checkpoint_path(folder_, step))) link_newest(folder_, step);
  });
}

void Checkpoints::write(long step, const std::function<void(Record&)>& transfer) {
  if (step == last_step_) return;
  const TimedScope timed(Phase::Output);
  const Model& model = simulation_.model();
  const auto name_all = [&](Record& record) {
    write_identity(record, simulation_);
    transfer(record);
  };
  write_checkpoint_file(checkpoint_path(folder_, step), model.space(), model.mesh(), name_all);
  last_step_ = step;
  last_time_ = Teuchos::Time::wallTime();
  steps_.erase(std::remove(steps_.begin(), steps_.end(), step), steps_.end());
  steps_.push_back(step);
  if (steps_.size() > static_cast<std::size_t>(options_.keep))
    steps_.erase(steps_.begin(), steps_.end() - options_.keep);
  on_first_rank(model.space().comm(), [&] {
    link_newest(folder_, step);
    tidy();
  });
}

void Checkpoints::tidy() const {
  std::error_code code;
  for (const long step : checkpoint_steps(folder_))
    if (std::find(steps_.begin(), steps_.end(), step) == steps_.end()) fs::remove(checkpoint_path(folder_, step), code);
  for (const std::string& name : names_in(folder_))
    if (name.rfind(prefix, 0) == 0 && fs::path(name).extension() == ".tmp") fs::remove(fs::path(folder_) / name, code);
}

}  // namespace ixos
