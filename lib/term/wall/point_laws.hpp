/// The law at the quadrature points of a surface.
#pragma once
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "base/record.hpp"
#include "interaction/gap_domain.hpp"
#include "interaction/law_history.hpp"
#include "mesh/local_mesh.hpp"
#include "state/history.hpp"
#include "term/interaction.hpp"

namespace ixos {

/// A law without a history is the same at all points: nothing is kept, and calls reach the law itself.
template <class Law, bool = HasHistory<Law>::value>
class PointLaws {
 public:
  using OfBatch = Law;

  PointLaws(const LocalMesh&, const std::vector<LocalSide>&, std::size_t /*points*/, const Law& law) : law_(law) {}

  /// Returns the law apart from histories.
  const Law& whole() const { return law_; }
  /// Returns the law with the histories of a state.
  const PointLaws& in(const TermHistories*, std::size_t /*slot*/) const { return *this; }
  /// Returns the law at the points of a batch, for SurfaceKernel, and at one of them.
  const OfBatch& of(std::size_t /*batch*/) const { return law_; }
  const Law& at(std::size_t /*batch*/, std::size_t /*point*/) const { return law_; }

 private:
  Law law_;
};

/// A law with a history, whose numbers at the points a TermHistory keeps. See HasHistory.
template <class Law>
class PointLaws<Law, true> {
 public:
  using OfBatch = LawOfBatch<Law>;

  /// The law at the points of one state.
  class Kept {
   public:
    Kept(const Law& law, const PointData& history) : law_(law), history_(history) {}
    OfBatch of(std::size_t batch) const { return {&law_, &history_(batch, 0)}; }
    auto at(std::size_t batch, std::size_t point) const { return law_.at(history_(batch, point)); }
    Pack damage(std::size_t batch, std::size_t point) const { return law_.damage(history_(batch, point)); }

   private:
    const Law& law_;
    const PointData& history_;
  };

  /// `points`: quadrature points of a side. Points begin without a past.
  PointLaws(const LocalMesh& mesh, const std::vector<LocalSide>& sides, std::size_t points, const Law& law)
      : law_(law), without_past_(mesh, sides, points, 1) {
    without_past_.fill(law_.first(Pack(0.0))[0]);
  }

  const Law& whole() const { return law_; }
  /// Throws std::logic_error without histories.
  Kept in(const TermHistories* histories, std::size_t slot) const {
    if (histories == nullptr) throw std::logic_error("a law with a history needs the histories of a state");
    return {law_, histories->of(slot).points.front().values};
  }

  TermHistory history() const { return {{{{{"history of the law", ColumnKind::Growing, 1}}, without_past_}}, {}, {}}; }
  /// Begins the history of a point at a gap [L0].
  void begin(Pack& history, const Pack& gap) const { history = law_.first(gap); }
  /// Accepts a step that ends at a gap. Returns the work that it dissipated per area [E0 L0].
  Pack accept(Pack& history, const Pack& gap) const {
    const Pack before = history;
    history = law_.updated(before, gap);
    return law_.dissipated(before, history);
  }

 private:
  Law law_;
  PointData without_past_;
};

/// The base of an interaction `Owner` of a surface with an obstacle, whatever its law. The owner has laws_, a
/// PointLaws<Law>.
template <class Owner, class Law>
class SurfaceInteractionTerm : public Interaction, public Admissibility, public SurfaceReport {
 public:
  const Rule& followed(const Rule& rule) const final { return rule; }
  bool follows(Mean) const final { return true; }
  bool has_friction() const final { return false; }
  const Admissibility& admissibility() const final { return *this; }
  const SurfaceReport& reports() const final { return *this; }
  Coupling* coupling() final { return nullptr; }
  const ObstacleMotion* motion() const final { return nullptr; }
  /// The factor of the law, 1 at first: no law's history depends on it.
  std::vector<std::string> parameters() const final { return {"Law Factor"}; }

  bool needs_positive_gaps() const final { return own().laws_.whole().domain == GapDomain::Positive; }
  bool is_clear(const Place&) const final { return false; }
  void report_friction(const Place&, FrictionReport&) const final {}

 protected:
  /// Returns the law at the points with these histories.
  decltype(auto) laws(const TermHistories* histories) const { return own().laws_.in(histories, this->slot()); }
  Owner& own() { return static_cast<Owner&>(*this); }
  const Owner& own() const { return static_cast<const Owner&>(*this); }
};

/// The steps of such an interaction, whose law may have a history. The owner calls it its friend and has sides_, its
/// SurfaceSides; add_nodal_pressure(place, sums), see SurfaceNumber; and for_each_gap(u, visit), which calls
/// visit(batch, quadrature point, gap, weight) with weights that count on this rank.
template <class Owner, class Law, bool = HasHistory<Law>::value>
class InteractionOverSteps : public SurfaceInteractionTerm<Owner, Law> {
 public:
  bool has(SurfaceNumber number) const final { return number == SurfaceNumber::Pressure; }
  void add_nodal(SurfaceNumber number, const Place& at, double* sums) const final {
    if (number == SurfaceNumber::Pressure) this->own().add_nodal_pressure(at, sums);
  }
};

template <class Owner, class Law>
class InteractionOverSteps<Owner, Law, true> : public SurfaceInteractionTerm<Owner, Law> {
 public:
  bool dissipates() const final { return true; }
  bool has_state() const final { return true; }
  bool has_history() const final { return true; }

  void initialize(const KnownState& start, TermHistories& histories) const final {
    PointData& kept = values(histories);
    this->own().for_each_gap(start.u, [&](std::size_t b, std::size_t q, const Pack& gap, const Pack&) {
      this->own().laws_.begin(kept(b, q), gap);
    });
  }
  /// The history follows the gap at the step's end, whatever the stages in between: there, force and energy with the
  /// old history and with the new one agree.
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const final {
    PointData& kept = values(histories);
    Pack sum = 0.0;
    this->own().for_each_gap(step.states.back().u,
                             [&](std::size_t b, std::size_t q, const Pack& gap, const Pack& weight) {
                               sum += weight * this->own().laws_.accept(kept(b, q), gap);
                             });
    return {total(sum), 0};
  }
  void transfer(Record& record, TermHistories& histories) final { values(histories).transfer(record); }

  bool has(SurfaceNumber number) const final {
    return number == SurfaceNumber::Pressure || number == SurfaceNumber::Damage;
  }
  void add_nodal(SurfaceNumber number, const Place& at, double* sums) const final {
    if (number == SurfaceNumber::Pressure) this->own().add_nodal_pressure(at, sums);
    if (number == SurfaceNumber::Damage) add_nodal_damage(at, sums);
  }

 protected:
  TermHistory create_history() const final { return this->own().laws_.history(); }

 private:
  PointData& values(TermHistories& histories) const { return histories.of(this->slot()).points.front().values; }

  void add_nodal_damage(const Place& at, double* by_node) const {
    const auto& sides = this->own().sides_;
    const auto laws = this->laws(at.histories);
    for (std::size_t b = 0; b < sides.size(); ++b) {
      std::array<Pack, std::decay_t<decltype(sides)>::N> sums{};
      for (std::size_t q = 0; q < sides.quadrature().size(); ++q)
        sides.add_weighted(b, q, sides.area(b)[q] * laws.damage(b, q), sums);
      sides.add_nodal(b, sums, by_node);
    }
  }
};

}  // namespace ixos
