/// Criteria that end a run before its final time.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "base/record.hpp"
#include "scene/read/probes.hpp"

namespace ixos {

/// Adds the parameters of a criterion to a valid list.
void declare_stop(Teuchos::ParameterList& list);

/// The list "Time Integrator/Stop": the run ends after the first step for which one of its criteria holds.
class StopCriteria {
 public:
  /// Throws InputError with the list path if a criterion asks for something that the scene does not have.
  StopCriteria(const SceneNode& list, const std::vector<Probe>& probes, const Model& model);

  /// Returns the reason for the end of the run, or an empty string while no criterion holds. Collective.
  std::string reason(const Model& model, const State& state);

  /// Writes or reads the state for checkpoints.
  void transfer(Record& record) { record.number("was attached", was_attached_); }

 private:
  struct Criterion {
    std::string name;
    const Probe* probe = nullptr;  ///< null: until detached, unless there is a set
    std::string set{};             ///< whose reaction is limited
    std::string quantity;
    bool above = true;
    double limit = 0;
  };
  static bool passes(const Criterion& criterion, double value);

  std::vector<Criterion> criteria_;
  bool was_attached_ = false;
};

}  // namespace ixos
