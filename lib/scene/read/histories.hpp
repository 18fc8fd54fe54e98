/// The named histories of a scene.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "histories/time_function.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// Adds the parameters of a history to a valid list.
void declare_history(Teuchos::ParameterList& list);

/// Moves the history of a list by so much in time [T0] and in value, in addition to what the list says already.
void shift_history(Teuchos::ParameterList& list, double time, double value);

/// The use of a history: a motion needs its derivatives.
enum class HistoryUse { Motion, Load };

/// Functions of the calling program by name, in plain numbers.
using GivenHistories = std::map<std::string, std::shared_ptr<const TimeFunction>>;

/// Returns the value at a time of the history of that name: of the program's, else of the validated list "Histories"; 0
/// if there is none.
double history_at(const SceneNode& list, const GivenHistories& given, const std::string& name, double time);

/// The list "Histories", which must outlive this. It is read at once; each history is checked over the run at the first
/// request for it. Functions of the program join those of the list; one of the same name takes the list's place.
class Histories {
 public:
  /// `statics`: the scheme has no inertia, so that a motion may jump. Throws InputError with the list path.
  Histories(const SceneNode& list, double initial_time, double final_time, const GivenHistories& given = {},
            bool statics = false);

  /// Returns the history of that name. Throws InputError if none has that name, if a table does not cover the run, or
  /// if the function is no such motion or load (see check_over). A function of the program is not checked: it may be
  /// set step by step.
  const std::shared_ptr<const TimeFunction>& get(const std::string& name, HistoryUse use) const;
  /// Returns whether the program gives it.
  bool is_given(const std::string& name) const { return given_.count(name) > 0; }
  /// Returns the functions of the program.
  const GivenHistories& given() const { return given_; }
  /// Returns a note for each ramp, and each table that still changes, that the run does not see to its end.
  std::vector<std::string> notes() const;

 private:
  std::map<std::string, std::shared_ptr<const TimeFunction>> functions_;
  GivenHistories given_;
  SceneNode list_;
  double initial_time_, final_time_;
  bool statics_;
};

}  // namespace ixos
