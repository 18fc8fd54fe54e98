#include "support/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "support/reports.hpp"

namespace ixos::test {

std::vector<double> gathered(const Model& model, const std::vector<double>& local) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> all(static_cast<std::size_t>(mesh.global_nodes + mesh.global_tied) * d, 0.0);
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node)
    for (std::size_t i = 0; i < d; ++i)
      all[static_cast<std::size_t>(mesh.original_ids[node]) * d + i] = local[node * d + i];
  model.space().sum(all.data(), static_cast<int>(all.size()));
  return all;
}

double total_energy(const Simulation& simulation) {
  const StateReport report = report_of(simulation);
  return report.momenta().kinetic_energy + report.energy(Part::Elastic) + report.energy(Part::Interaction);
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace ixos::test
