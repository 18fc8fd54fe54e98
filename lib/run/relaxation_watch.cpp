#include "run/relaxation_watch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "material/maxwell_branch.hpp"

namespace ixos {

void RelaxationWatch::step(const std::vector<HistoryStress>& bodies, double dt) {
  std::size_t count = 0;
  for (const HistoryStress& body : bodies) count += body.branches.size();
  if (branches_.size() != count) branches_.assign(count, Branch());  // the first step, or a restart with others
  auto branch = branches_.begin();
  double error = 0, stress = 0, active = 0;
  for (const HistoryStress& body : bodies) {
    double sum = 0;
    for (std::size_t n = 0; n < body.branches.size(); ++n, ++branch) {
      const double x = dt / body.times[n];
      const HistoryStep own = history_step(x, body.update), exact = exact_history_step(x);
      const double factor = 1 - exact.change / own.change;
      branch->sum = exact.lag * (branch->sum + (branch->factor - factor) * branch->stress) +
                    (own.lag - exact.lag) * exact.change / own.change * branch->stress;
      branch->stress = body.branches[n];
      branch->factor = factor;
      const double direct = factor * branch->stress;
      sum += std::max(std::abs(direct), std::abs(direct + branch->sum));
    }
    error += sum * sum;
    stress += body.all * body.all;
    active += body.sum * body.sum;
  }
  const double weight = dt * std::sqrt(active);
  error_ += weight * std::sqrt(error);
  stress_ += weight * std::sqrt(stress);
}

void RelaxationWatch::transfer(Record& record) {
  const Record::Section section(record, "relaxation");
  record.number("error", error_);
  record.number("stress", stress_);
  auto count = branches_.size();
  record.number("branches", count);
  // A checkpoint of another scene has other branches.
  std::vector<Branch> branches;
  for (std::size_t k = 0; k < count; ++k) {
    const Record::Section own(record, "branch " + std::to_string(k + 1));
    Branch branch = record.loading() ? Branch() : branches_[k];
    record.number("stress", branch.stress);
    record.number("sum", branch.sum);
    record.number("factor", branch.factor);
    branches.push_back(branch);
  }
  if (record.loading()) branches_ = record.same_scene() ? branches : std::vector<Branch>();
}

}  // namespace ixos
