/// The named histories of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <map>
#include <memory>
#include <string>

#include "model/time_function.hpp"

namespace ixos {

/// What a history is used for: a motion needs its derivatives.
enum class HistoryUse { Motion, Load };

/// The list "Histories", read at once; each is checked over the run when it is first asked for.
class Histories {
 public:
  /// Throws InputError with the list path.
  Histories(const Teuchos::ParameterList& list, double initial_time, double final_time);

  /// Throws InputError where there is none of that name, where a table or a ramp does not fit the run, or where the
  /// function is no such motion or load (see check_over).
  const std::shared_ptr<const TimeFunction>& get(const std::string& name, HistoryUse use) const;

 private:
  std::map<std::string, std::shared_ptr<const TimeFunction>> functions_;
  Teuchos::ParameterList list_;
  double initial_time_, final_time_;
};

}  // namespace ixos
