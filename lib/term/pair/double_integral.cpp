#include "term/pair/double_integral.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "term/pair/dense_pairs.hpp"
#include "term/pair/pair_action.hpp"

namespace ixos {
namespace {

template <std::size_t D>
class DoubleIntegral final : public Interaction, public Coupling, public SurfaceReport {
 public:
  DoubleIntegral(const LocalMesh& mesh, PairSurfaces<D> surfaces, const Pattern& pattern,
                 std::unique_ptr<Interaction> distance, const PairKernel<D>& kernel, int points)
      : pattern_(pattern),
        coordinates_(mesh.coordinates),
        surfaces_(std::move(surfaces)),
        distance_(std::move(distance)),
        pairs_(surfaces_, kernel, points),
        nodes_(surfaces_.secondary.nodes),
        acts_(acting_patches(surfaces_, mesh)),
        scratch_(coordinates_.size()) {
    nodes_.insert(nodes_.end(), surfaces_.primary.nodes.begin(), surfaces_.primary.nodes.end());
  }

  const Rule& followed(const Rule& rule) const override { return rule; }
  bool follows(Mean mean) const override { return mean == Mean::Points; }
  bool has_friction() const override { return false; }
  const Admissibility& admissibility() const override { return distance_->admissibility(); }
  const SurfaceReport& reports() const override { return *this; }
  Coupling* coupling() override { return this; }
  const ObstacleMotion* motion() const override { return nullptr; }
  bool has_time_derivative(const Rule&) const override { return true; }
  void add_time_derivative(const Segment&, const Rule&, double*) const override {}
  /// The factor of the kernel: the distance has no forces.
  std::vector<std::string> parameters() const override { return {"Law Factor"}; }
  bool add_parameter_derivative(std::size_t parameter, const Segment& segment, const Rule& rule,
                                double* f) const override {
    return add_factor_derivative(parameter, segment, rule, f);
  }

  bool update_stencils(const double*) override { return !std::exchange(coupled_, true); }
  std::vector<std::vector<int>> stencils() const override {
    if (!coupled_) return {};
    return {nodes_};
  }

  void initialize(const KnownState& start, TermHistories& histories) const override {
    distance_->initialize(start, histories);
  }
  void begin_step(const StepStart& start, StepMemories& step) const override { distance_->begin_step(start, step); }
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override {
    return distance_->accept(step, histories);
  }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    check(rule);
    for (const RulePoint& point : rule.points) {
      const auto sums = pairs_.gradient(places(segment, point), acts_);
      for (std::size_t n = 0; n < nodes_.size(); ++n)
        for (std::size_t i = 0; i < D; ++i) f[D * static_cast<std::size_t>(nodes_[n]) + i] += point.weight * sums[n][i];
    }
    return distance_->add_force(segment, rule, scratch_.data());
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    visit_block(segment, rule, kind, [&](const PairBlock& block) { add_to_matrix<D>(block, pattern_, values); });
  }
  std::unique_ptr<TangentAction> create_action() const override {
    return std::make_unique<PairAction<D>>([this](const Segment& segment, const Rule& rule, Tangent kind,
                                                  const auto& visit) { visit_block(segment, rule, kind, visit); });
  }
  bool add_row_sums(const Segment& segment, double* sums) const override {
    visit_block(segment, end_rule(), Tangent::Exact,
                [&](const PairBlock& block) { ixos::add_row_sums<D>(block, sums); });
    return distance_->add_force(segment, end_rule(), scratch_.data());
  }

  double energy(const Place& at) const override { return pairs_.energy(places(at.u), counts()); }
  /// Throws std::logic_error: the mean over the path has no closed form.
  double mean_potential(const Segment&) const override {
    throw std::logic_error("the mean force between two surfaces has no closed form");
  }

  double rounding(const Place& at) const override { return distance_->rounding(at); }

  void report(const Place& at, InteractionReport& report) const override {
    InteractionReport of_distance;
    distance_->reports().report(at, of_distance);
    report.measure += of_distance.measure;
    report.least_gap = std::min(report.least_gap, of_distance.least_gap);
    report.force.resize(D, 0.0);
    const Vec<D> force = pairs_.force(places(at.u), counts());
    for (std::size_t i = 0; i < D; ++i) report.force[i] += force[i];
  }
  void report_friction(const Place&, FrictionReport&) const override {}
  bool has(SurfaceNumber number) const override { return distance_->reports().has(number); }
  void add_nodal(SurfaceNumber number, const Place& at, double* sums) const override {
    distance_->reports().add_nodal(number, at, sums);
  }
  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    distance_->reports().add_nodal_measure(counted, measure);
  }
  void lower_nodal_gap(const Place& at, double* gap) const override { distance_->reports().lower_nodal_gap(at, gap); }
  void lower_facing_gap(const Place& at, double* gap) const override { distance_->reports().lower_facing_gap(at, gap); }
  void set_nodal_normal(const Place& at, double* normal) const override {
    distance_->reports().set_nodal_normal(at, normal);
  }

 protected:
  std::vector<Term*> inside() const override { return {distance_.get()}; }

 private:
  static void check(const Rule& rule) {
    if (rule.mean != Mean::Points) throw std::logic_error("the double integral over two surfaces needs time points");
  }
  const std::vector<char>& counts() const { return surfaces_.secondary.owned; }

  PairPlaces<D> combine(const NodeParts& parts) const {
    return {combined_places<D>(surfaces_.secondary.nodes, coordinates_, 1, parts),
            combined_places<D>(surfaces_.primary.nodes, coordinates_, 1, parts)};
  }
  PairPlaces<D> places(const double* u) const { return combine({{{1, u}, {0, nullptr}, {0, nullptr}}}); }
  PairPlaces<D> places(const Segment& segment, const RulePoint& point) const {
    return combine({{{point.to, segment.to}, {point.from, segment.from}, {point.velocity, segment.velocity}}});
  }

  /// All nodes of both surfaces in one block.
  void visit_block(const Segment& segment, const Rule& rule, Tangent kind,
                   const std::function<void(const PairBlock&)>& visit) const {
    check(rule);
    PairBlock block{0, 0, nodes_, std::vector<double>(D * nodes_.size() * D * nodes_.size(), 0.0)};
    for (const RulePoint& point : rule.points)
      if (const double factor = point.weight * point.to; factor != 0)
        pairs_.add_hessian(places(segment, point), acts_, kind, factor, block.k);
    visit(block);
  }

  const Pattern& pattern_;
  std::vector<double> coordinates_;  ///< of the local mesh
  PairSurfaces<D> surfaces_;
  std::unique_ptr<Interaction> distance_;
  DensePairs<D> pairs_;
  std::vector<int> nodes_;  ///< local, of the secondary, then of the primary surface
  std::vector<char> acts_;  ///< by secondary patch: its points add to forces on this rank's nodes
  bool coupled_ = false;
  mutable std::vector<double> scratch_;  ///< for a force that nobody reads
};

}  // namespace

template <std::size_t D>
std::unique_ptr<Interaction> make_double_integral(const LocalMesh& mesh, PairSurfaces<D> surfaces,
                                                  const Pattern& pattern, std::unique_ptr<Interaction> distance,
                                                  const PairKernel<D>& kernel, int points) {
  return std::make_unique<DoubleIntegral<D>>(mesh, std::move(surfaces), pattern, std::move(distance), kernel, points);
}

template std::unique_ptr<Interaction> make_double_integral(const LocalMesh&, PairSurfaces<2>, const Pattern&,
                                                           std::unique_ptr<Interaction>, const PairKernel<2>&, int);
template std::unique_ptr<Interaction> make_double_integral(const LocalMesh&, PairSurfaces<3>, const Pattern&,
                                                           std::unique_ptr<Interaction>, const PairKernel<3>&, int);

}  // namespace ixos
