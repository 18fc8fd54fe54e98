#include "run/handover.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/all_to_all.hpp"
#include "base/memory_record.hpp"
#include "run/energies.hpp"

namespace ixos {
namespace {

/// The record of a state that goes to another model with the same nodes on each rank.
class Handover final : public MemoryRecord {
 public:
  Handover(Values& values, bool loading, const DofSpace& space)
      : MemoryRecord(values, loading ? 0 : 1), space_(space) {}

  bool same_scene() const override { return false; }
  bool same_solution() const override { return false; }
  bool same_partition() const override { return false; }  // the sides and cells of a rank may be others

  void field(const char* name, std::vector<double>& values, Extent extent) override {
    std::vector<double>& kept = of(name).numbers;
    const auto owned = static_cast<std::size_t>(space_.owned());
    std::vector<double>& globals = of((std::string(name) + " of rigid bodies").c_str()).numbers;
    if (!loading()) {
      kept.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(std::min(owned, values.size())));
      if (extent == Extent::Local && !values.empty())
        globals.assign(values.begin() + space_.first_global(), values.end());
      return;
    }
    values = kept;
    if (space_.maximum(kept.empty() ? 0 : 1) == 0) return;
    values.resize(extent == Extent::Local ? static_cast<std::size_t>(space_.local()) : owned, 0.0);
    if (extent == Extent::Owned) return;
    space_.update_ghosts(values.data());
    // Stages may have other bodies: those that are new begin in their places.
    const auto shared = std::min(globals.size(), static_cast<std::size_t>(space_.globals().numbers));
    std::copy_n(globals.begin(), shared, values.begin() + space_.first_global());
  }
  void all_shares(const char* name, std::vector<double>& values) override {
    values = of_all_ranks(of(name).numbers, space_.comm());
  }

 private:
  const DofSpace& space_;
};

void add_velocities(Simulation& simulation) {
  Integrator& integrator = simulation.integrator();
  State state = integrator.state();
  const std::vector<double> given = simulation.given_velocities();
  // Bodies go on with the velocities that they have.
  const auto nodes = static_cast<std::size_t>(simulation.model().space().first_global());
  for (std::size_t i = 0; i < nodes; ++i) state.v[i] += given[i];
  integrator.resume(state, integrator.works());
}

}  // namespace

void hand_over(Simulation& from, Simulation& to) {
  MemoryRecord::Values values;
  Handover out(values, false, from.model().space());
  from.integrator().transfer(out);
  Handover in(values, true, to.model().space());
  Integrator& integrator = to.integrator();
  integrator.transfer(in);
  if (to.stages().any() && to.stages().gives_velocities(to.stage())) add_velocities(to);
  const double before = energies_of(from).total(), after = energies_of(to).total();
  const bool same = std::abs(after - before) <= 1e-12 * std::max(std::abs(before), std::abs(after));
  integrator.continue_works(from.integrator(), same ? 0 : after - before);
}

}  // namespace ixos
