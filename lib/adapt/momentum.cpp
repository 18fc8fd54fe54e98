#include "adapt/momentum.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "mesh/connected_parts.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Rigid velocities: translations, then spins about a point. A body of revolution has the translation along its axis.
class RigidMotions {
 public:
  RigidMotions(int dimension, bool axisymmetric) : d_(at(dimension)), axisymmetric_(axisymmetric) {}

  std::size_t count() const { return axisymmetric_ ? 1 : d_ == 2 ? 3 : 6; }
  /// Sets the velocity of a point in motion k.
  void set(std::size_t k, const double* x, const double* centre, double* v) const {
    std::fill_n(v, d_, 0.0);
    if (axisymmetric_) {
      v[1] = 1;
    } else if (k < d_) {
      v[k] = 1;
    } else if (d_ == 2) {
      v[0] = -(x[1] - centre[1]);
      v[1] = x[0] - centre[0];
    } else {
      const std::size_t i = (k - 3 + 1) % 3, j = (k - 3 + 2) % 3;
      v[i] = -(x[j] - centre[j]);
      v[j] = x[i] - centre[i];
    }
  }

 private:
  std::size_t d_;
  bool axisymmetric_;
};

/// A model's nodes by part, and where they are.
class Parts {
 public:
  Parts(const Model& model, const Mesh& mesh, const std::vector<double>& u)
      : model_(model), d_(at(mesh.dimension)), x_(u.size()), motions_(mesh.dimension, mesh.axisymmetric) {
    const std::vector<int> all = connected_parts(mesh);
    for (const int original : model.mesh().original_ids) part_.push_back(all[at(original)]);
    for (std::size_t i = 0; i < u.size(); ++i) x_[i] = model.mesh().coordinates[i] + u[i];
    for (const int part : all)
      if (part >= 0) parts_.insert(part);
  }

  const std::set<int>& parts() const { return parts_; }
  const RigidMotions& motions() const { return motions_; }

  /// Returns the rigid motions of a part that its supports allow. Collective.
  std::vector<std::size_t> allowed(int part, const std::array<double, 3>& centre) const {
    std::vector<std::size_t> allowed;
    for (std::size_t k = 0; k < motions_.count(); ++k) {
      const std::vector<double> v = rigid(part, k, centre);
      std::vector<double> kept = v;
      for (const int dof : model_.constraints().dofs()) kept[at(dof)] = 0;
      model_.constraints().planes().project(kept.data(), model_.mesh().owned_nodes);
      double largest = 0, lost = 0;
      for (std::size_t i = 0; i < at(model_.space().owned()); ++i) {
        largest = std::max(largest, std::abs(v[i]));
        lost = std::max(lost, std::abs(v[i] - kept[i]));
      }
      if (model_.space().maximum(lost) <= 1e-12 * model_.space().maximum(largest)) allowed.push_back(k);
    }
    return allowed;
  }

  /// Returns the mean place of a part's nodes. Collective.
  std::array<double, 3> centre(int part) const {
    std::array<double, 4> sums{};
    for_each_owned(part, [&](std::size_t node) {
      for (std::size_t i = 0; i < d_; ++i) sums[i] += x_[node * d_ + i];
      sums[3] += 1;
    });
    model_.space().sum(sums.data(), 4);
    return {sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
  }

  /// Returns a rigid velocity of a part, zero elsewhere: a local array.
  std::vector<double> rigid(int part, std::size_t k, const std::array<double, 3>& centre) const {
    std::vector<double> v(x_.size(), 0.0);
    for (std::size_t node = 0; node < part_.size(); ++node)
      if (part_[node] == part) motions_.set(k, &x_[node * d_], centre.data(), &v[node * d_]);
    return v;
  }

  /// Returns the sums of rigid velocities times M v over a part: its momenta. Collective.
  std::vector<double> momenta(int part, const std::array<double, 3>& centre, const std::vector<double>& v) const {
    std::vector<double> p(at(model_.space().owned()), 0.0), sums(motions_.count(), 0.0);
    model_.mass()->multiply(v.data(), p.data());
    for (std::size_t k = 0; k < sums.size(); ++k)
      for_each_owned(part, [&](std::size_t node) {
        std::array<double, 3> own{};
        motions_.set(k, &x_[node * d_], centre.data(), own.data());
        for (std::size_t i = 0; i < d_; ++i) sums[k] += own[i] * p[node * d_ + i];
      });
    model_.space().sum(sums.data(), static_cast<int>(sums.size()));
    return sums;
  }

 private:
  template <class Visit>
  void for_each_owned(int part, const Visit& visit) const {
    for (std::size_t node = 0; node < at(model_.mesh().owned_nodes); ++node)
      if (part_[node] == part) visit(node);
  }

  const Model& model_;
  std::size_t d_;
  std::vector<double> x_;  ///< deformed places, a local array
  RigidMotions motions_;
  std::vector<int> part_;  ///< by local node
  std::set<int> parts_;
};

}  // namespace

void restore_momenta(const Model& before, const Mesh& mesh_before, const State& state, const Model& after,
                     const Mesh& mesh, const std::vector<double>& u, std::vector<double>& v) {
  const Parts old(before, mesh_before, state.u), now(after, mesh, u);
  for (const int part : now.parts()) {
    const std::array<double, 3> centre = now.centre(part);
    const std::vector<std::size_t> motions = now.allowed(part, centre);
    const std::vector<double> wanted = old.momenta(part, centre, state.v), has = now.momenta(part, centre, v);
    std::vector<double> missing, matrix;
    for (const std::size_t k : motions) missing.push_back(wanted[k] - has[k]);
    for (const std::size_t k : motions) {
      const std::vector<double> column = now.momenta(part, centre, now.rigid(part, k, centre));
      for (const std::size_t other : motions) matrix.push_back(column[other]);
    }
    const auto n = static_cast<int>(motions.size());
    std::vector<int> pivots(motions.size());
    int info = 0;
    if (n > 0) Teuchos::LAPACK<int, double>().GESV(n, 1, matrix.data(), n, pivots.data(), missing.data(), n, &info);
    if (info != 0) continue;  // a part without mass
    for (std::size_t m = 0; m < motions.size(); ++m) {
      const std::vector<double> rigid = now.rigid(part, motions[m], centre);
      for (std::size_t i = 0; i < v.size(); ++i) v[i] += missing[m] * rigid[i];
    }
  }
}

}  // namespace ixos
