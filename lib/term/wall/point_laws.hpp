/// The law at the quadrature points of a surface.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/record.hpp"
#include "base/scratch.hpp"
#include "interaction/gap_law.hpp"
#include "mesh/local_mesh.hpp"
#include "state/history.hpp"
#include "term/interaction.hpp"

namespace ixos {

/// A law, and what a law with a history keeps at the points: a number each, in a TermHistory. See HasHistory.
class PointLaws {
 public:
  /// `places`: of the quadrature points along a side, see PointColumns. Points begin without a past.
  PointLaws(const LocalMesh& mesh, const std::vector<LocalSide>& sides,
            const std::vector<std::array<double, 3>>& places, std::shared_ptr<const GapLaw> law)
      : law_(std::move(law)), domain_(law_->domain()) {
    equilibrium_gap_ = law_->equilibrium_gap();
    adhesion_gap_ = law_->adhesion_gap();
    if (!law_->has_history()) return;
    places_ = places;
    without_past_.emplace(mesh, sides, places.size(), 1);
    without_past_->fill(law_->first(Pack(0.0))[0]);
  }

  bool has_history() const { return without_past_.has_value(); }
  GapDomain domain() const { return domain_; }
  double equilibrium_gap() const { return equilibrium_gap_; }
  double adhesion_gap() const { return adhesion_gap_; }

  /// The law at the points of one state.
  class Kept {
   public:
    Kept(const GapLaw& law, const PointData* history) : law_(law), history_(history) {}
    /// Returns it at the points of a batch, and at one of them.
    GapLawOfBatch of(std::size_t batch) const {
      return {&law_, history_ == nullptr ? nullptr : &(*history_)(batch, 0)};
    }
    GapLawAt at(std::size_t batch, std::size_t point) const {
      return {&law_, history_ == nullptr ? nullptr : &(*history_)(batch, point)};
    }
    Pack damage(std::size_t batch, std::size_t point) const { return law_.damage((*history_)(batch, point)); }

   private:
    const GapLaw& law_;
    const PointData* history_;
  };

  /// Returns the law with the histories of a state. Throws std::logic_error if it needs some and there are none.
  Kept in(const TermHistories* histories, std::size_t slot) const {
    if (!has_history()) return {*law_, nullptr};
    if (histories == nullptr) throw std::logic_error("a law with a history needs the histories of a state");
    return {*law_, &histories->of(slot).points.front().values};
  }

  TermHistory history() const {
    if (!has_history()) return {};
    return {{{{{"history of the law", ColumnKind::Nearest, 1}}, *without_past_, places_}}, {}, {}};
  }
  /// Begins the history of a point at a gap [L0].
  void begin(Pack& history, const Pack& gap) const { history = law_->first(gap); }
  /// Accepts a step that ends at a gap. Returns the work that it dissipated per area [E0 L0].
  Pack accept(Pack& history, const Pack& gap) const {
    const Pack before = history;
    history = law_->updated(before, gap);
    return law_->dissipated(before, history);
  }

 private:
  std::shared_ptr<const GapLaw> law_;
  GapDomain domain_;
  double equilibrium_gap_ = 0, adhesion_gap_ = 0;
  std::optional<PointData> without_past_;
  std::vector<std::array<double, 3>> places_;
};

/// The base of an interaction `Owner` of a surface with an obstacle. The owner calls it its friend and has laws_, a
/// PointLaws; sides_, a pointer to its WallSides; add_nodal_pressure(place, sums), see SurfaceNumber; and
/// for_each_gap(u, visit), which calls visit(batch, quadrature point, gap, weight) with weights that count on this
/// rank.
template <class Owner>
class SurfaceInteractionTerm : public Interaction, public Admissibility, public SurfaceReport {
 public:
  const Rule& followed(const Rule& rule) const final { return rule; }
  bool follows(Mean) const final { return true; }
  bool has_friction() const final { return false; }
  bool has_time_derivative(const Rule&) const final { return true; }
  const Admissibility& admissibility() const final { return *this; }
  const SurfaceReport& reports() const final { return *this; }
  Coupling* coupling() final { return nullptr; }
  const ObstacleMotion* motion() const final { return nullptr; }
  /// The factor of the law, 1 at first: no law's history depends on it.
  std::vector<std::string> parameters() const final { return {"Law Factor"}; }
  bool add_parameter_derivative(std::size_t parameter, const Segment& segment, const Rule& rule,
                                double* f) const final {
    return this->add_factor_derivative(parameter, segment, rule, f);
  }

  bool needs_positive_gaps() const final { return own().laws_.domain() == GapDomain::Positive; }
  bool is_clear(const Place&) const final { return false; }
  void report_friction(const Place&, FrictionReport&) const final {}

  bool dissipates() const final { return keeps(); }
  bool has_state() const final { return keeps(); }
  bool has_history() const final { return keeps(); }

  void initialize(const KnownState& start, TermHistories& histories) const final {
    if (!keeps()) return;
    PointData& kept = values(histories);
    own().for_each_gap(start.u, [&](std::size_t b, std::size_t q, const Pack& gap, const Pack&) {
      own().laws_.begin(kept(b, q), gap);
    });
  }
  /// The history follows the gap at the step's end, whatever the stages in between: there, force and energy with the
  /// old history and with the new one agree.
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const final {
    if (!keeps()) return {};
    PointData& kept = values(histories);
    Pack sum = 0.0;
    own().for_each_gap(step.states.back().u, [&](std::size_t b, std::size_t q, const Pack& gap, const Pack& weight) {
      sum += weight * own().laws_.accept(kept(b, q), gap);
    });
    return {total(sum), 0};
  }
  void transfer(Record& record, TermHistories& histories) final {
    if (keeps()) values(histories).transfer(record);
  }

  bool has(SurfaceNumber number) const final {
    return number == SurfaceNumber::Pressure || (number == SurfaceNumber::Damage && keeps());
  }
  void add_nodal(SurfaceNumber number, const Place& at, double* sums) const final {
    if (number == SurfaceNumber::Pressure) own().add_nodal_pressure(at, sums);
    if (number == SurfaceNumber::Damage && keeps()) add_nodal_damage(at, sums);
  }

 protected:
  TermHistory create_history() const final { return own().laws_.history(); }
  /// Returns the law at the points with these histories.
  PointLaws::Kept laws(const TermHistories* histories) const { return own().laws_.in(histories, this->slot()); }
  Owner& own() { return static_cast<Owner&>(*this); }
  const Owner& own() const { return static_cast<const Owner&>(*this); }

 private:
  bool keeps() const { return own().laws_.has_history(); }
  PointData& values(TermHistories& histories) const { return histories.of(this->slot()).points.front().values; }

  void add_nodal_damage(const Place& at, double* by_node) const {
    const auto& sides = *own().sides_;
    const PointLaws::Kept laws = this->laws(at.histories);
    Scratch<Pack> damages(sides.points());
    for (std::size_t b = 0; b < sides.size(); ++b) {
      for (std::size_t q = 0; q < damages.size(); ++q) damages[q] = sides.area(b)[q] * laws.damage(b, q);
      sides.add_weighted_nodal(b, damages.data(), by_node);
    }
  }
};

}  // namespace ixos
