#include "run/run_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "run/replaced_results.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_file.hpp"

namespace ixos {

bool Recording::due(long step, double before, double now) const {
  if (interval_ == 0) return steps_ > 0 && step % steps_ == 0;
  const double slack = 1e-9 * (now - start_);
  return std::floor((now - start_ + slack) / interval_) > std::floor((before - start_ + slack) / interval_);
}

RunFiles::RunFiles(Simulation& simulation, const std::string& folder, const std::string& scene_file)
    : simulation_(simulation),
      folder_(folder),
      scene_file_(scene_file),
      history_(simulation),
      rows_(simulation.output().history_interval, simulation.output().history_time_interval,
            simulation.step_control().initial_time),
      frames_(simulation.output().fields_interval, simulation.output().fields_time_interval,
              simulation.step_control().initial_time) {
  name_frames();
}

/// Returns the path of a file of this simulation: that of the first one has no number.
std::string RunFiles::numbered(const std::string& name, long exchanges, const std::string& extension) const {
  return folder_ + "/" + name + (exchanges == 0 ? "" : "-" + std::to_string(exchanges + 1)) + extension;
}

/// Frames of another mesh, or with other fields, need a file of their own. Viewers open those of a mesh that follows
/// the front as one series by the name of the first.
void RunFiles::name_frames() {
  if (!frames_.any()) return;
  const std::string name = simulation_.adaptation().on() && frame_files_ > 0
                               ? fmt::format("{}-s.{:04}", numbered("fields", 0, ".e"), frame_files_ + 1)
                               : numbered("fields", frame_files_, ".e");
  fields_ = std::make_unique<FieldRecorder>(simulation_, name, scene_file_);
}

void RunFiles::go_on_from(RunFiles& before, bool on_other_mesh) {
  history_.go_on_from(before.history_);
  if (before.fields_ && !before.framed_ && !on_other_mesh) before.record_frame();
  if (before.frames_begun_) {
    before.fields_->sync();
    before.fields_->close();
  }
  counts_ = before.counts_;
  recorded_ = before.recorded_;
  if (on_other_mesh) {
    exchanges_ = before.exchanges_;
    frame_files_ = before.frame_files_ + (before.frames_begun_ ? 1 : 0);
    framed_ = before.framed_;
    return name_frames();
  }
  exchanges_ = before.exchanges_ + 1;
  const bool goes_on = simulation_.stage() > 0 && fields_ && before.fields_ && fields_->has_fields_of(*before.fields_);
  frame_files_ = before.frame_files_ + (goes_on || !before.frames_begun_ ? 0 : 1);
  name_frames();
  on_first_rank(simulation_.model().space().comm(), [&] { write_scene_file(simulation_.parameters(), scene_path()); });
  if (!goes_on && fields_) begin_frames();
  if (!goes_on) return;
  framed_ = true;
  if (!before.frames_begun_) return;  // the mesh changed after the last frame: the file begins with its first one
  fields_->resume(before.fields_->length());
  frames_begun_ = true;
}

void RunFiles::open_folder(bool goes_on) {
  const bool keep_present = has_frames() || !fields_;
  on_first_rank(simulation_.model().space().comm(), [&] {
    std::error_code code;
    std::filesystem::create_directories(folder_, code);
    if (code) throw FileError("the results folder cannot be used: " + folder_ + ": " + code.message());
    for (const std::string& name : names_in(folder_)) {
      const NumberedResult of = numbered_result(name);
      const bool is_later = of.frames > frame_files_ + 1 || of.scene > exchanges_ + 1;
      const bool keep_frames = goes_on && (keep_present || of.frames <= frame_files_);
      if (!is_later && name != "summary.json" && (keep_frames || of.frames == 0)) continue;
      const std::filesystem::path path = std::filesystem::path(folder_) / name;
      std::filesystem::remove(path, code);
      if (code) throw FileError(path.string() + ": cannot be replaced: " + code.message());
    }
    write_scene_file(simulation_.parameters(), scene_path());
    // The scene of all stages, where a restart begins a folder with a later one.
    const std::string whole = numbered("effective", 0, ".xml");
    if (simulation_.stage() > 0 && !goes_on) write_scene_file(complete_scene(simulation_.stages().scene({})), whole);
  });
}

void RunFiles::create() {
  // A restart in another folder begins with fields.e.
  if (frame_files_ > 0 && (exchanges_ == 0 || simulation_.adaptation().on())) {
    frame_files_ = 0;
    name_frames();
  }
  history_.create(history_path());
  if (fields_) begin_frames();
  row(true);
  recorded_ = framed_ = true;
}

void RunFiles::verify() {
  history_.verify(history_path());
  if (has_frames()) fields_->verify(field_length_);
}

void RunFiles::resume() {
  history_.resume(history_path());
  frames_begun_ = has_frames();
  if (frames_begun_) {
    fields_->resume(field_length_);
  } else if (fields_ && simulation_.adaptation().on()) {
    name_frames();  // the file begins with its first frame
  } else if (fields_) {
    begin_frames();
  }
}

void RunFiles::begin_frames() {
  record_frame();
  framed_ = true;
}

void RunFiles::record_frame() {
  if (!frames_begun_) fields_->create();
  frames_begun_ = true;
  fields_->record();
}

void RunFiles::count(const StepResult& attempt, double wall_seconds) {
  counts_.newton_iterations += attempt.newton_iterations;
  counts_.linear_iterations += attempt.linear_iterations;
  counts_.wall_seconds = wall_seconds;
}

void RunFiles::row(bool is_first) {
  history_.record(counts_, is_first);
  counts_.newton_iterations = counts_.linear_iterations = 0;
}

void RunFiles::record(long step, double dt, double before) {
  counts_.step = step;
  counts_.time_step = dt;
  const double now = simulation_.integrator().time();
  recorded_ = rows_.due(step, before, now);
  if (recorded_)
    row();
  else
    history_.pass();
  framed_ = frames_.due(step, before, now);
  if (fields_ && framed_) record_frame();
}

void RunFiles::finish() {
  if (!recorded_) row();
  if (fields_ && !framed_) record_frame();
  history_.close();
  if (!frames_begun_) return;
  fields_->sync();
  fields_->close();
}

bool RunFiles::end_stage() {
  if (recorded_) return false;
  row();
  recorded_ = true;
  return true;
}

void RunFiles::sync() {
  history_.sync();
  if (frames_begun_) fields_->sync();
}

void RunFiles::transfer(Record& record, long step, double wall_seconds) {
  record.number("time step", counts_.time_step);
  record.number("newton iterations since the row", counts_.newton_iterations);
  record.number("linear iterations since the row", counts_.linear_iterations);
  record.number("recorded", recorded_);
  const long exchanges = exchanges_, frame_files = frame_files_;
  if (record.loading()) exchanges_ = 0;
  if (record.loading() ? record.has_section("exchanges") : exchanges_ > 0 || frame_files_ > 0) {
    const Record::Section section(record, "exchanges");
    record.number("count", exchanges_);
    record.number("files of frames", frame_files_);
  }
  if (exchanges_ != exchanges || frame_files_ != frame_files) name_frames();
  record.number("framed", framed_);
  if (!record.loading()) field_length_ = frames_begun_ ? fields_->length() : FieldLength();
  record.number("frames", field_length_.frames);
  std::vector<double> bytes{field_length_.bytes};
  if (!record.loading() || record.same_partition()) record.share("bytes of frames", bytes);
  if (!record.loading()) return;
  field_length_.bytes = bytes.empty() ? 0 : bytes[0];
  counts_.step = step;
  counts_.wall_seconds = wall_seconds;
}

}  // namespace ixos
