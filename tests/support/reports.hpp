/// Reports on states in tests.
#pragma once
#include "model/state_report.hpp"
#include "scene/simulation.hpp"

namespace ixos::test {

/// The report on a simulation's present state.
inline StateReport report_of(const Simulation& simulation) {
  return {simulation.model(), simulation.integrator().state()};
}

struct HistoriesWithoutPast {
  TermHistories histories;
};

/// The report on a state whose terms have no past.
class ReportAt : private HistoriesWithoutPast, public StateReport {
 public:
  ReportAt(const Model& model, const double* u, const double* v = nullptr, double time = 0)
      : HistoriesWithoutPast{model.create_histories()}, StateReport(model, Place{u, time, &histories, nullptr, v}) {}
};

}  // namespace ixos::test
