/// The law at the quadrature points of a surface.
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "base/record.hpp"
#include "discretization/point_data.hpp"
#include "interaction/law_history.hpp"
#include "mesh/local_mesh.hpp"
#include "term/interaction.hpp"

namespace ixos {

/// A law without a history is the same at all points: nothing is kept, and calls reach the law itself.
template <class Law, bool = HasHistory<Law>::value>
class PointLaws {
 public:
  static constexpr bool has_history = false;
  using OfBatch = Law;

  PointLaws(const LocalMesh&, const std::vector<LocalSide>&, std::size_t /*points*/, const Law& law) : law_(law) {}

  /// Returns the law apart from histories.
  const Law& whole() const { return law_; }
  /// Returns the law at the points of a batch, for SurfaceKernel, and at one of them.
  const OfBatch& of(std::size_t /*batch*/) const { return law_; }
  const Law& at(std::size_t /*batch*/, std::size_t /*point*/) const { return law_; }

 private:
  Law law_;
};

/// A law with a history, and the history of each point. See HasHistory.
template <class Law>
class PointLaws<Law, true> {
 public:
  static constexpr bool has_history = true;
  using OfBatch = LawOfBatch<Law>;

  /// `points`: quadrature points of a side. Points begin without a past.
  PointLaws(const LocalMesh& mesh, const std::vector<LocalSide>& sides, std::size_t points, const Law& law)
      : law_(law), history_(mesh, sides, points, 1) {
    history_.fill(law_.first(Pack(0.0))[0]);
  }

  const Law& whole() const { return law_; }
  OfBatch of(std::size_t batch) const { return {&law_, &history_(batch, 0)}; }
  auto at(std::size_t batch, std::size_t point) const { return law_.at(history_(batch, point)); }
  Pack damage(std::size_t batch, std::size_t point) const { return law_.damage(history_(batch, point)); }

  /// Begins the history of a point at a gap [L0].
  void begin(std::size_t batch, std::size_t point, const Pack& gap) { history_(batch, point) = law_.first(gap); }
  /// Accepts a step that ends at a gap. Returns the work that it dissipated per area [E0 L0].
  Pack accept(std::size_t batch, std::size_t point, const Pack& gap) {
    Pack& history = history_(batch, point);
    const Pack before = history;
    history = law_.updated(before, gap);
    return law_.dissipated(before, history);
  }
  void transfer(Record& record) { history_.transfer(record); }

 private:
  Law law_;
  PointData history_;
};

/// The base of an interaction `Term` of a surface with laws_, a PointLaws<Law>: what it does over steps if its law has
/// a history. The term calls it its friend and has sides_, its SurfaceSides, and for_each_gap(u, visit), which calls
/// visit(batch, quadrature point, gap, weight) with weights that count on this rank.
template <class Owner, class Law, bool = HasHistory<Law>::value>
class InteractionOverSteps : public Interaction {};

template <class Owner, class Law>
class InteractionOverSteps<Owner, Law, true> : public Interaction {
 public:
  bool dissipates() const final { return true; }
  bool has_state() const final { return true; }
  bool has_history() const final { return true; }

  void initialize(const KnownState& start) final {
    own().for_each_gap(
        start.u, [&](std::size_t b, std::size_t q, const Pack& gap, const Pack&) { own().laws_.begin(b, q, gap); });
  }
  /// The history follows the gap at the step's end, whatever the stages in between: there, force and energy with the
  /// old history and with the new one agree.
  double accept(const AcceptedStep& step) final {
    Pack sum = 0.0;
    own().for_each_gap(step.states.back().u, [&](std::size_t b, std::size_t q, const Pack& gap, const Pack& weight) {
      sum += weight * own().laws_.accept(b, q, gap);
    });
    return total(sum);
  }
  void transfer(Record& record) final { own().laws_.transfer(record); }

  bool has_damage() const final { return true; }
  void add_nodal_damage(double* by_node) const final {
    const Owner& term = static_cast<const Owner&>(*this);
    const auto& sides = term.sides_;
    for (std::size_t b = 0; b < sides.size(); ++b) {
      std::array<Pack, std::decay_t<decltype(sides)>::N> sums{};
      for (std::size_t q = 0; q < sides.quadrature().size(); ++q)
        sides.add_weighted(b, q, sides.area(b)[q] * term.laws_.damage(b, q), sums);
      sides.add_nodal(b, sums, by_node);
    }
  }

 private:
  Owner& own() { return static_cast<Owner&>(*this); }
};

}  // namespace ixos
