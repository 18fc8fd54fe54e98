#include "model/branch_reports.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "material/elastic_law.hpp"
#include "model/traits.hpp"

namespace ixos {

double history_error(const Model& model, const Segment& step) {
  if (!has_viscoelasticity(model)) return 0;
  const LocalMesh& mesh = model.mesh();
  const DofSpace& space = model.space();
  double sums[2] = {0, 0};
  for (const Body& body : model.bodies()) {
    if (body.viscoelasticity == nullptr) continue;
    double modulus = body.material.law->lame().mu;
    for (const MaxwellBranch& branch : body.material.branches) modulus += branch.modulus;
    const std::array<double, 2> own = body.viscoelasticity->squared_error(step);
    sums[0] += own[0] / (modulus * modulus);
    sums[1] += own[1];
  }
  space.sum(sums, 2);
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double size = 0;
  for (std::size_t i = 0; i < d; ++i) {
    double highest = -std::numeric_limits<double>::infinity(), lowest = -highest;
    for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node) {
      if (mesh.is_derivative(node)) continue;
      highest = std::max(highest, mesh.coordinates[node * d + i]);
      lowest = std::min(lowest, mesh.coordinates[node * d + i]);
    }
    size = std::max(size, space.maximum(highest) + space.maximum(-lowest));
  }
  return size * std::sqrt(sums[0] / sums[1]);
}

std::vector<HistoryStress> history_stresses(const Model& model, const TermHistories& histories) {
  std::vector<HistoryStress> stresses;
  std::vector<double> squares;
  std::vector<double> moduli;
  for (const Body& body : model.bodies()) {
    if (body.viscoelasticity == nullptr) continue;
    const BranchSquares own = body.viscoelasticity->last_squares(histories);
    HistoryStress stress;
    stress.update = body.material.history_update;
    for (const MaxwellBranch& branch : body.material.branches) stress.times.push_back(branch.time);
    stress.branches = own.branches;
    stress.branches.resize(stress.times.size(), 0.0);  // no step was accepted yet
    squares.insert(squares.end(), stress.branches.begin(), stress.branches.end());
    squares.insert(squares.end(), {own.sum, own.strain});
    moduli.push_back(body.material.law->lame().mu);
    stresses.push_back(std::move(stress));
  }
  if (stresses.empty()) return stresses;
  model.space().sum(squares.data(), static_cast<int>(squares.size()));
  auto square = squares.begin();
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    for (double& branch : stresses[i].branches) branch = std::sqrt(*square++);
    stresses[i].sum = std::sqrt(*square++);
    stresses[i].all = stresses[i].sum + moduli[i] * std::sqrt(*square++);
  }
  return stresses;
}

}  // namespace ixos
