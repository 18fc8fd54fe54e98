#include "term/pair/two_passes.hpp"

#include <algorithm>
#include <utility>

#include "base/record.hpp"

namespace ixos {
namespace {

class TwoPasses final : public Interaction, public Admissibility, public Coupling, public SurfaceReport {
 public:
  TwoPasses(std::unique_ptr<Interaction> first, std::unique_ptr<Interaction> second, bool reacts)
      : first_(std::move(first)), second_(std::move(second)), reacts_(reacts) {}

  const Rule& followed(const Rule& rule) const override { return rule; }
  bool follows(Mean mean) const override { return first_->follows(mean) && second_->follows(mean); }
  bool is_gradient(const Rule& rule) const override { return first_->is_gradient(rule) && second_->is_gradient(rule); }
  bool has_friction() const override { return false; }
  const Admissibility& admissibility() const override { return *this; }
  const SurfaceReport& reports() const override { return *this; }
  Coupling* coupling() override { return this; }
  const ObstacleMotion* motion() const override { return nullptr; }

  void place(const Pattern& pattern) override {
    first_->place(pattern);
    second_->place(pattern);
  }
  bool update_stencils(const double* u) override {
    const bool first = first_->coupling()->update_stencils(u), second = second_->coupling()->update_stencils(u);
    return first || second;
  }
  std::vector<std::vector<int>> stencils() const override {
    std::vector<std::vector<int>> all = first_->coupling()->stencils();
    for (std::vector<int>& own : second_->coupling()->stencils()) all.push_back(std::move(own));
    return all;
  }

  void initialize(const KnownState& start, TermHistories& histories) const override {
    first_->initialize(start, histories);
    second_->initialize(start, histories);
  }
  void begin_step(const StepStart& start, StepMemories& step) const override {
    first_->begin_step(start, step);
    second_->begin_step(start, step);
  }
  void begin_stage(const StageStart& start, StepMemories& step) const override {
    first_->begin_stage(start, step);
    second_->begin_stage(start, step);
  }
  bool dissipates() const override { return first_->dissipates() || second_->dissipates(); }
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override {
    const StepWork first = first_->accept(step, histories), second = second_->accept(step, histories);
    return {first.dissipated + second.dissipated, first.driven + second.driven};
  }
  bool has_state() const override { return true; }
  bool has_history() const override { return first_->has_history() || second_->has_history(); }
  bool outlives_scene() const override { return first_->outlives_scene() || second_->outlives_scene(); }
  void transfer(Record& record, TermHistories& histories) override {
    const auto transfer = [&](const char* name, Interaction& pass) {
      const Record::Section section(record, name);
      pass.transfer(record, histories);
    };
    transfer("first pass", *first_);
    transfer("second pass", *second_);
  }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    return first_->add_force(segment, rule, f) && second_->add_force(segment, rule, f);
  }
  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override {
    first_->add_tangent(segment, rule, kind, values);
    second_->add_tangent(segment, rule, kind, values);
  }
  std::unique_ptr<TangentAction> create_action() const override {
    return std::make_unique<Action>(first_->create_action(), second_->create_action());
  }
  bool add_row_sums(const Segment& segment, double* sums) const override {
    return first_->add_row_sums(segment, sums) && second_->add_row_sums(segment, sums);
  }
  std::unique_ptr<KeptPoints> create_kept() const override { return nullptr; }
  bool has_time_derivative(const Rule& rule) const override {
    return first_->has_time_derivative(rule) && second_->has_time_derivative(rule);
  }
  void add_time_derivative(const Segment& segment, const Rule& rule, double* f) const override {
    first_->add_time_derivative(segment, rule, f);
    second_->add_time_derivative(segment, rule, f);
  }
  /// Both passes have the same law.
  std::vector<std::string> parameters() const override { return first_->parameters(); }
  bool add_parameter_derivative(std::size_t parameter, const Segment& segment, const Rule& rule,
                                double* f) const override {
    return first_->add_parameter_derivative(parameter, segment, rule, f) &&
           second_->add_parameter_derivative(parameter, segment, rule, f);
  }
  double energy(const Place& at) const override {
    return (reacts_ ? 1 : 0.5) * (first_->energy(at) + second_->energy(at));
  }
  double mean_potential(const Segment& segment) const override {
    return first_->mean_potential(segment) + second_->mean_potential(segment);
  }
  double rounding(const Place& at) const override { return first_->rounding(at) + second_->rounding(at); }

  bool needs_positive_gaps() const override { return of_first().needs_positive_gaps(); }
  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override {
    return std::min(of_first().admissible_step(segment, rule, direction),
                    second_->admissibility().admissible_step(segment, rule, direction));
  }
  double gap_ratio(const Segment& way) const override {
    return std::max(of_first().gap_ratio(way), second_->admissibility().gap_ratio(way));
  }
  LowestPoint lowest_point(const Place& at) const override { return of_first().lowest_point(at); }
  bool is_clear(const Place& at) const override { return of_first().is_clear(at); }
  LowestPoint passage(const Segment& way) const override { return of_first().passage(way); }

  void report(const Place& at, InteractionReport& report) const override {
    InteractionReport other;
    first_->reports().report(at, report);
    second_->reports().report(at, other);
    report.least_gap = std::min(report.least_gap, other.least_gap);
    if (!reacts_) return;
    for (std::size_t i = 0; i < report.force.size(); ++i) report.force[i] -= other.force[i];
  }
  void report_friction(const Place& at, FrictionReport& report) const override {
    for_each_report([&](const SurfaceReport& own) { own.report_friction(at, report); });
  }
  bool has(SurfaceNumber number) const override { return first_->reports().has(number); }
  void add_nodal(SurfaceNumber number, const Place& at, double* sums) const override {
    for_each_report([&](const SurfaceReport& own) { own.add_nodal(number, at, sums); });
  }
  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    for_each_report([&](const SurfaceReport& own) { own.add_nodal_measure(counted, measure); });
  }
  void lower_nodal_gap(const Place& at, double* gap) const override {
    for_each_report([&](const SurfaceReport& own) { own.lower_nodal_gap(at, gap); });
  }
  void lower_facing_gap(const Place&, double*) const override {}  // both surfaces have gaps of their own
  void set_nodal_normal(const Place& at, double* normal) const override {
    for_each_report([&](const SurfaceReport& own) { own.set_nodal_normal(at, normal); });
  }

 protected:
  std::vector<Term*> inside() const override { return {first_.get(), second_.get()}; }

 private:
  const Admissibility& of_first() const { return first_->admissibility(); }
  template <class Visit>
  void for_each_report(const Visit& visit) const {
    visit(first_->reports());
    visit(second_->reports());
  }

  class Action final : public TangentAction {
   public:
    Action(std::unique_ptr<TangentAction> first, std::unique_ptr<TangentAction> second)
        : first_(std::move(first)), second_(std::move(second)) {}
    void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart& linear) override {
      first_->linearize(segment, rule, kind, linear);
      second_->linearize(segment, rule, kind, linear);
    }
    bool applies_mass() const override { return false; }
    bool has_coarse() const override { return false; }
    void add_product(const double* x, double* y) const override {
      first_->add_product(x, y);
      second_->add_product(x, y);
    }
    void add_diagonal(double* d) const override {
      first_->add_diagonal(d);
      second_->add_diagonal(d);
    }

   private:
    std::unique_ptr<TangentAction> first_, second_;
  };

  std::unique_ptr<Interaction> first_, second_;
  bool reacts_;
};

}  // namespace

std::unique_ptr<Interaction> two_passes(std::unique_ptr<Interaction> first, std::unique_ptr<Interaction> second,
                                        bool reacts) {
  return std::make_unique<TwoPasses>(std::move(first), std::move(second), reacts);
}

}  // namespace ixos
