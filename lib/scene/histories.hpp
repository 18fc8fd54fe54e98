/// The named histories of a scene.
#pragma once
#include <map>
#include <memory>
#include <string>

#include "histories/time_function.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// The use of a history: a motion needs its derivatives.
enum class HistoryUse { Motion, Load };

/// The list "Histories", which must outlive this. It is read at once; each history is checked over the run at the first
/// request for it.
class Histories {
 public:
  /// Throws InputError with the list path.
  Histories(const SceneNode& list, double initial_time, double final_time);

  /// Returns the history of that name. Throws InputError if none has that name, if a table or a ramp does not fit the
  /// run, or if the function is no such motion or load (see check_over).
  const std::shared_ptr<const TimeFunction>& get(const std::string& name, HistoryUse use) const;

 private:
  std::map<std::string, std::shared_ptr<const TimeFunction>> functions_;
  SceneNode list_;
  double initial_time_, final_time_;
};

}  // namespace ixos
