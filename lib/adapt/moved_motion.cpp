#include "adapt/moved_motion.hpp"

#include <algorithm>

#include "adapt/field_at.hpp"
#include "adapt/momentum.hpp"
#include "adapt/projection.hpp"
#include "adapt/whole_field.hpp"
#include "base/error.hpp"
#include "time/mass_solver.hpp"

namespace ixos {
namespace {

/// Adds to the velocities of an interpolation what the mass projection of the velocities before has beyond them.
void project(const SplitMesh& from, const std::vector<double>& before, const SplitMesh& to, const Model& model,
             const std::vector<double>& interpolated, std::vector<double>& v) {
  const DofSpace& space = model.space();
  std::vector<double> missing = missing_momentum(from, before, to, model, interpolated);
  missing.resize(static_cast<std::size_t>(space.owned()));
  model.constraints().planes().project(missing.data(), model.mesh().owned_nodes);
  for (const int dof : model.constraints().dofs())
    if (dof < space.owned()) missing[static_cast<std::size_t>(dof)] = 0;
  const bool none = std::all_of(missing.begin(), missing.end(), [](double p) { return p == 0; });
  if (space.maximum(none ? 0 : 1) == 0) return;
  std::vector<double> change(v.size(), 0.0);
  if (model.mass()->is_lumped()) {
    model.mass()->divide(missing.data(), change.data());
    space.update_ghosts(change.data());
  } else if (!MassSolver(model, nullptr).solve(std::move(missing), change.data())) {
    throw InputError("the system of the mass is not solved, by which velocities go to the other mesh");
  }
  for (std::size_t i = 0; i < v.size(); ++i) v[i] += change[i];
}

}  // namespace

Motion moved_motion(const SplitMesh& from, const Model& before, const State& state, const SplitMesh& to,
                    const Model& after) {
  const auto d = static_cast<std::size_t>(to.mesh().dimension);
  std::vector<double> old;
  const auto on_other = [&](const std::vector<double>& field) {
    old = whole_field(before.mesh(), before.space().comm(), field, d, from.mesh().nodes());
    std::vector<double> local = local_field(after.mesh(), interpolated(from, old, d, to), d);
    after.space().interpolate_tied(local.data());
    return local;
  };
  Motion motion;
  motion.u = on_other(state.u);
  motion.v = on_other(state.v);
  if (after.mass() == nullptr) return motion;
  // With tied nodes as their masters move them.
  const std::vector<double> now = whole_field(after.mesh(), after.space().comm(), motion.v, d, to.mesh().nodes());
  project(from, old, to, after, now, motion.v);
  restore_momenta(before, from.mesh(), state, after, to.mesh(), motion.u, motion.v);
  return motion;
}

}  // namespace ixos
