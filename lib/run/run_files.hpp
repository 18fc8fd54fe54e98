/// history.csv and fields.e of a run, and the folder they are in.
#pragma once
#include <memory>
#include <string>

#include "base/record.hpp"
#include "run/field_recorder.hpp"
#include "run/history.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// The steps that are recorded: every n-th, or those that pass a multiple of a time interval.
class Recording {
 public:
  Recording(int steps, double interval, double start) : steps_(steps), interval_(interval), start_(start) {}
  bool any() const { return steps_ > 0 || interval_ > 0; }
  bool due(long step, double before, double now) const;

 private:
  long steps_;
  double interval_;
  double start_;
};

/// Records the states of a run as the scene's list "Output" says. Everything throws FileError; collective.
class RunFiles {
 public:
  /// `scene_file`: the path of the scene, for the records of fields.e; may be empty.
  RunFiles(Simulation& simulation, const std::string& folder, const std::string& scene_file = "");

  /// Makes the folder and effective.xml; what an earlier run left is not this one's, but for frames that are gone on
  /// with.
  void open_folder(bool goes_on);
  /// New files, which begin with the present state.
  void create();
  /// Are the files those that were there when the loaded checkpoint was written? Throws InputError where they are not.
  void verify();
  /// Goes on with them, once verified; what came after the checkpoint is dropped. Frames begin where there were none.
  void resume();

  /// Gives the last state of a stage a row, unless it has one. Returns whether it did.
  bool end_stage();
  /// Goes on with the rows of another simulation, which ends, and with frames in a new file, whose first one is the
  /// present state. A stage with the same fields appends to the file of the stage before; after a change of the mesh
  /// the new file begins with the next frame that is due. Throws InputError, on all ranks, if the columns are others.
  void go_on_from(RunFiles& before, bool on_other_mesh);

  /// A step that was attempted, and the clock after it.
  void count(const StepResult& attempt, double wall_seconds);
  /// The present state: that of a step of length dt from the time `before`. It has a row and a frame where they are
  /// due.
  void record(long step, double dt, double before);
  /// The present state has a row and a frame, and the rows reach the file.
  void finish();
  void sync();  ///< has the disk keep rows and frames

  History& history() { return history_; }
  bool recorded() const { return recorded_; }  ///< whether the present state has a row
  /// For checkpoints: all but what history() transfers. The run stands at that step and time of the clock.
  void transfer(Record& record, long step, double wall_seconds);

 private:
  bool has_frames() const { return fields_ && field_length_.frames > 0; }
  void record_frame();
  void begin_frames();
  void row(bool is_first = false);
  std::string history_path() const { return folder_ + "/history.csv"; }
  std::string numbered(const std::string& name, long exchanges, const std::string& extension) const;
  std::string scene_path() const { return numbered("effective", exchanges_, ".xml"); }
  void name_frames();

  Simulation& simulation_;
  std::string folder_, scene_file_;
  History history_;
  std::unique_ptr<FieldRecorder> fields_;
  Recording rows_, frames_;
  RowCounts counts_;
  long exchanges_ = 0;         ///< of simulations before this one
  long frame_files_ = 0;       ///< before the present one
  bool recorded_ = true;       ///< has the present state a row?
  bool framed_ = true;         ///< and a frame?
  bool frames_begun_ = false;  ///< has the present file of frames been made?
  FieldLength field_length_;   ///< in the folder of the checkpoint that was loaded
};

}  // namespace ixos
