#include "run/energy_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "interaction/gap_law.hpp"
#include "model/traits.hpp"

namespace ixos {
namespace {

/// Returns whether some interaction is that of two bodies.
bool has_pairs(const Model& model) {
  return std::any_of(model.interactions().begin(), model.interactions().end(),
                     [](const NamedInteraction& named) { return !named.term->follows(Mean::Exact); });
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
  // gap ratio bounds nothing, nor the place where a law ends, nor the way of a foot over the sides of another body.
  const bool points = simulation.integrator().table().interaction_points > 0;
  const bool ends =
      std::any_of(simulation.interactions().begin(), simulation.interactions().end(),
                  [](const SceneInteraction& own) { return own.cutoff > 0 || std::isfinite(own.law->range()); });
  if (points && (has_moved_obstacles(model) || has_laws_of_every_gap(model) || ends || has_pairs(model))) return;
  by_scheme_ = true;
  // Each step of Newton's method leaves a residual that does work, see step().
  allowed_ = promise + 10 * simulation.newton().tolerance;
  const Rule& elastic = simulation.integrator().table().stages.front().elastic;
  elastic_points_ = elastic.mean == Mean::Points ? static_cast<int>(elastic.points.size()) : 0;
}

void EnergyWatch::step(const Integrator& integrator) {
  if (!by_scheme_) return;
  const int points = integrator.table().interaction_points;
  if (points > 0) quadrature_ += quadrature_error(points, integrator.gap_ratio());
  if (elastic_points_ > 0) quadrature_ += elastic_quadrature_error(elastic_points_, integrator.edge_change());
  work_ += integrator.unbalanced_work();
}

std::string EnergyWatch::look(long step, double balance, double largest_energy) {
  const double change = std::abs(balance - last_);
  const auto steps = static_cast<double>(std::max(step - last_step_, 1L));
  const double bound = (allowed_ * steps + quadrature_) * largest_energy + work_;
  const bool first = std::isnan(last_), good = first ? std::isfinite(balance) : change <= bound;
  last_ = balance;
  last_step_ = step;
  quadrature_ = work_ = 0;
  if (good) return "";
  constexpr double far = 1e3;  // a step that is a little too long misses the bound by less
  return fmt::format(
      "step {}: the energy balance moved by {:.3g}, and {} as it is set keeps it within {:.3g}: the step is too long "
      "for its points in time{}",
      step, change, scheme_, bound, change <= far * bound ? "" : ", or memory was damaged");
}

void EnergyWatch::transfer(Record& record) {
  const Record::Section section(record, "watch");
  record.number("balance", last_);
  record.number("step", last_step_);
  record.number("quadrature", quadrature_);
  record.number("work", work_);
}

}  // namespace ixos
