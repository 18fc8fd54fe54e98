/// When a run ends before its final time.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "checkpoint/record.hpp"
#include "scene/probes.hpp"

namespace ixos {

/// The list "Time Integrator/Stop": the run ends after the first step for which one of its criteria holds.
class StopCriteria {
 public:
  /// Throws InputError with the list path where a criterion asks for what the scene does not have.
  StopCriteria(const Teuchos::ParameterList& list, const std::vector<Probe>& probes, const Model& model);

  /// Why the run is over, or nothing. Collective.
  std::string reason(const Model& model, const State& state);

  /// For checkpoints.
  void transfer(Record& record) { record.number("was attached", was_attached_); }

 private:
  struct Criterion {
    std::string name;
    const Probe* probe = nullptr;  ///< null: until detached
    std::string quantity;
    bool above = true;
    double limit = 0;
  };
  std::vector<Criterion> criteria_;
  bool was_attached_ = false;
};

}  // namespace ixos
