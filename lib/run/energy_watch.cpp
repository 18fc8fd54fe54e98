#include "run/energy_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

/// Returns whether some interaction is that of two bodies.
bool has_pairs(const Model& model) {
  return std::any_of(model.force_terms().begin(), model.force_terms().end(), [](const NamedForceTerm& named) {
    const auto* own = dynamic_cast<const Interaction*>(named.term);
    return own != nullptr && !own->follows(Mean::Exact);
  });
}

}  // namespace

EnergyWatch::EnergyWatch(const Simulation& simulation) : scheme_(simulation.time_integrator().scheme) {
  const WatchOptions& options = simulation.output().watch;
  if (options.action == WatchAction::Off || !simulation.output().energies) return;
  action_ = options.action;
  allowed_ = options.tolerance;
  const double promise = simulation.integrator().table().energy_promise;
  const Model& model = simulation.model();
  if (allowed_ > 0 || promise == 0 || !model.dissipation_names().empty()) return;
  // Points in time integrate neither the work of a moved obstacle exactly, nor the kinks of a law of every gap, whose
  // gap ratio bounds nothing, nor the way of a foot over the sides of another body.
  const bool points = simulation.integrator().table().interaction_points > 0;
  if (points && (model.has_moved_obstacles() || model.has_laws_of_every_gap() || has_pairs(model))) return;
  by_scheme_ = true;
  // Each step of Newton's method leaves a residual that does work.
  allowed_ = promise + 10 * simulation.newton().tolerance;
}

void EnergyWatch::step(int interaction_points, const std::function<double()>& gap_ratio) {
  if (by_scheme_ && interaction_points > 0) quadrature_ += quadrature_error(interaction_points, gap_ratio());
}

std::string EnergyWatch::look(long step, double balance, double largest_energy) {
  const double change = std::abs(balance - last_);
  const auto steps = static_cast<double>(std::max(step - last_step_, 1L));
  const double bound = (allowed_ * steps + quadrature_) * largest_energy;
  const bool first = std::isnan(last_), good = first ? std::isfinite(balance) : change <= bound;
  last_ = balance;
  last_step_ = step;
  quadrature_ = 0;
  if (good) return "";
  return fmt::format(
      "step {}: the energy balance moved by {:.3g}, and {} as it is set keeps it within {:.3g}: the step is too long "
      "for its points in time, or memory was damaged",
      step, change, scheme_, bound);
}

void EnergyWatch::transfer(Record& record) {
  const Record::Section section(record, "watch");
  record.number("balance", last_);
  record.number("step", last_step_);
  record.number("quadrature", quadrature_);
}

}  // namespace ixos
