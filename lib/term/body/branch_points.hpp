/// The Maxwell branches at the quadrature points of a block.
#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/record.hpp"
#include "element/branch_sum.hpp"
#include "material/maxwell_branch.hpp"
#include "mesh/local_mesh.hpp"
#include "state/history.hpp"

namespace ixos {

/// Branches of a material. A TermHistory keeps Ci - I of each: as many numbers a branch and point as a symmetric tensor
/// has components, 6 in three dimensions and 4 in a plane; beside them what each point has dissipated. Each of the
/// functions evaluates one point; `kept` are the values of that TermHistory. `Gradient` is a displacement gradient, 2 x
/// 2 in plane strain, else 3 x 3.
template <class Components, std::size_t G>
class BranchPoints {
 public:
  using Gradient = Small<Pack, G>;
  using Tensor = Small<Pack, 3>;
  using Strain = IsochoricStrain<Components, Pack>;
  using Branch = FrozenBranch<Components, Pack>;
  using Step = BranchStep<Pack>;
  using Steps = std::vector<Step>;

  /// Squares at a point after a step, at small strains, where half of mu (Cb - Ci) is a branch's stress.
  struct StepSquares {
    std::vector<Pack> branches;  ///< of each stress [E0^2]
    Pack sum;                    ///< of their sum [E0^2]
    Pack strain;                 ///< of half of Cb - I [-]
  };

  BranchPoints(const LocalBlock& block, std::size_t points, const std::vector<MaxwellBranch>& branches)
      : branches_(branches), relaxed_(block, points, branches.size() * size + 1) {}

  /// Returns the history of the undeformed, relaxed state. Nothing is dissipated yet.
  /// `places`: see PointColumns.
  TermHistory history(const std::vector<std::array<double, 3>>& places) const {
    PointColumns columns{{}, relaxed_, places};  // one transfer, which may throw
    for (std::size_t n = 0; n < branches_.size(); ++n)
      columns.columns.push_back({fmt::format("branch {}", n + 1), ColumnKind::UnimodularTensor, size});
    columns.columns.push_back({"dissipated", ColumnKind::Growing, 1});
    return {{std::move(columns)}, {}, {}};
  }
  /// Throws InputError, on all ranks, if the checkpoint has branches of other times: their histories are not these.
  void transfer(Record& record, PointData& kept) const {
    std::vector<double> times = branch_times();
    std::size_t count = times.size();
    record.number("branches", count);
    if (count > 1000000) throw InputError("the number of branches is damaged");
    times.resize(count);
    for (std::size_t n = 0; n < count; ++n) record.number(("time " + std::to_string(n + 1)).c_str(), times[n]);
    if (times != branch_times())
      throw InputError(
          fmt::format("the checkpoint has {} Maxwell branches of the relaxation times {}, the scene {} of {}; their "
                      "histories do not "
                      "fit others",
                      count, fmt::join(times, ", "), branches_.size(), fmt::join(branch_times(), ", ")));
    kept.transfer(record);
  }

  /// Returns the energy dissipated per reference volume [E0].
  const Pack& dissipated(const PointData& kept, std::size_t b, std::size_t q) const {
    return kept(b, q, branches_.size() * size);
  }

  /// Returns the steps of all branches for a length [T0]; 0 freezes histories.
  Steps steps(double length) const {
    Steps result;
    for (const MaxwellBranch& branch : branches_) result.push_back({length, branch.time});
    return result;
  }

  static Strain strain(const Gradient& h) { return Strain(in_space(h)); }

  /// Returns the stored energy, given the steps of length 0, and the potential of a step [E0].
  Pack stored(const PointData& kept, std::size_t b, std::size_t q, const Gradient& h, const Steps& frozen) const {
    return sum(kept, b, q, strain(h), frozen, [](const Branch& branch) { return branch.stored(); });
  }
  Pack potential(const PointData& kept, std::size_t b, std::size_t q, const Gradient& h, const Steps& steps) const {
    return sum(kept, b, q, strain(h), steps, [](const Branch& branch) { return branch.potential(); });
  }

  /// Returns the first Piola-Kirchhoff stress, 3 x 3 [E0].
  Tensor stress(const PointData& kept, std::size_t b, std::size_t q, const Strain& strain, const Steps& steps) const {
    BranchSum<Components, Pack> result(strain);
    for (std::size_t n = 0; n < branches_.size(); ++n)
      result.add(branches_[n].modulus, Branch(strain, history(kept, b, q, n), steps[n]));
    return result.stress();
  }

  /// Adds weight times dP/dF to the lower triangle.
  template <std::size_t C>
  void add_moduli(const PointData& kept, std::size_t b, std::size_t q, const Gradient& h, const Steps& steps,
                  const Pack& weight, Small<Pack, C>& moduli) const {
    if constexpr (std::is_same_v<Components, PlaneComponents>)
      add_moduli_without_calls(kept, b, q, h, steps, weight, moduli);
    else
      add_moduli_at(kept, b, q, h, steps, weight, moduli);
  }

  /// Accepts a step of length dt between two displacement gradients; `force` are the steps of its force. Returns the
  /// energy that it dissipated per reference volume [E0], see step_dissipation(), and sets the squares.
  Pack accept(PointData& kept, std::size_t b, std::size_t q, const Gradient& from, const Gradient& to,
              const Steps& force, double dt, HistoryUpdate update, StepSquares& squares) const {
    const Strain start(in_space(from)), end(in_space(to));
    std::optional<Strain> middle;
    if (update == HistoryUpdate::SecondOrder) middle.emplace(in_space(mean(from, to)));
    Pack lost = 0.0;
    Tensor all{};
    squares.branches.resize(branches_.size());
    for (std::size_t n = 0; n < branches_.size(); ++n) {
      const double time = branches_[n].time;
      const Tensor old = history(kept, b, q, n);
      const Tensor updated = update == HistoryUpdate::BackwardEuler
                                 ? Branch(end, old, {dt, time}).updated()
                                 : Branch(*middle, old, midpoint_step(*middle, old, dt, time)).updated();
      lost += branches_[n].modulus * step_dissipation(start, end, old, updated, force[n]);
      for (std::size_t k = 0; k < size; ++k)
        kept(b, q, n * size + k) = updated[Components::symmetric[k][0]][Components::symmetric[k][1]];
      Tensor own{};
      for (const auto& [i, j] : Components::all) {
        own[i][j] = branches_[n].modulus * (end.change[i][j] - updated[i][j]);
        all[i][j] += own[i][j];
      }
      squares.branches[n] = 0.25 * Strain::Algebra::contraction(own, own);
    }
    squares.sum = 0.25 * Strain::Algebra::contraction(all, all);
    squares.strain = 0.25 * Strain::Algebra::contraction(end.change, end.change);
    kept(b, q, branches_.size() * size) += lost;
    return lost;
  }

  /// Returns [E0^2] the square of half the sum of mu times the local error of Ci in a step of length dt between two
  /// displacement gradients: the difference from Ci' = (Cb - Ci)/tau with Cb on the straight line, which holds at small
  /// strains.
  Pack squared_error(const PointData& kept, std::size_t b, std::size_t q, const Gradient& from, const Gradient& to,
                     double dt, HistoryUpdate update) const {
    const Strain start(in_space(from)), end(in_space(to));
    Tensor sum{};
    for (std::size_t n = 0; n < branches_.size(); ++n) {
      const auto [of_lag, of_change] = error_factors(dt / branches_[n].time, update);
      const Tensor old = history(kept, b, q, n);
      for (const auto& [i, j] : Components::all)
        sum[i][j] += branches_[n].modulus *
                     (of_lag * (start.change[i][j] - old[i][j]) + of_change * (end.change[i][j] - start.change[i][j]));
    }
    return 0.25 * Strain::Algebra::contraction(sum, sum);
  }

 private:
  template <std::size_t C>
  [[gnu::always_inline]] void add_moduli_at(const PointData& kept, std::size_t b, std::size_t q, const Gradient& h,
                                            const Steps& steps, const Pack& weight, Small<Pack, C>& moduli) const {
    const Strain strain(in_space(h));
    BranchModuli<Components, Pack> sum;
    for (std::size_t n = 0; n < branches_.size(); ++n)
      sum.add(branches_[n].modulus, strain, Branch(strain, history(kept, b, q, n), steps[n]));
    sum.add_to(weight, strain, moduli);
  }
  /// Does the same with all calls inline. In a plane they would cost as much as the few components, in space they spare
  /// registers.
  template <std::size_t C>
  [[gnu::flatten]] void add_moduli_without_calls(const PointData& kept, std::size_t b, std::size_t q, const Gradient& h,
                                                 const Steps& steps, const Pack& weight, Small<Pack, C>& moduli) const {
    add_moduli_at(kept, b, q, h, steps, weight, moduli);
  }

  /// Returns the factors of Cb - Ci at the start, and of the change of Cb, in the local error of Ci; x = dt/tau.
  static std::array<double, 2> error_factors(double x, HistoryUpdate update) {
    const HistoryStep own = history_step(x, update), exact = exact_history_step(x);
    return {own.lag - exact.lag, own.change - exact.change};
  }

  static constexpr std::size_t size = Components::symmetric.size();

  static Gradient mean(const Gradient& from, const Gradient& to) {
    Gradient half;
    for (std::size_t i = 0; i < G; ++i)
      for (std::size_t j = 0; j < G; ++j) half[i][j] = 0.5 * (from[i][j] + to[i][j]);
    return half;
  }

  static Tensor in_space(const Gradient& h) {
    Tensor result{};
    for (std::size_t i = 0; i < G; ++i)
      for (std::size_t j = 0; j < G; ++j) result[i][j] = h[i][j];
    return result;
  }

  static Tensor history(const PointData& kept, std::size_t b, std::size_t q, std::size_t branch) {
    Tensor result;
    for (std::size_t k = 0; k < size; ++k) {
      const auto [i, j] = Components::symmetric[k];
      result[i][j] = result[j][i] = kept(b, q, branch * size + k);
    }
    return result;
  }

  std::vector<double> branch_times() const {
    std::vector<double> times;
    for (const MaxwellBranch& branch : branches_) times.push_back(branch.time);
    return times;
  }

  /// Returns the sum of modulus times value(branch).
  template <class Value>
  Pack sum(const PointData& kept, std::size_t b, std::size_t q, const Strain& strain, const Steps& steps,
           const Value& value) const {
    Pack result = 0.0;
    for (std::size_t n = 0; n < branches_.size(); ++n)
      result += branches_[n].modulus * value(Branch(strain, history(kept, b, q, n), steps[n]));
    return result;
  }

  std::vector<MaxwellBranch> branches_;
  PointData relaxed_;  ///< branches x components, then the dissipated energy, all zero
};

}  // namespace ixos
