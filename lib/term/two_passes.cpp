#include "term/two_passes.hpp"

#include <algorithm>
#include <utility>

#include "base/record.hpp"

namespace ixos {
namespace {

class TwoPasses final : public Interaction {
 public:
  TwoPasses(std::unique_ptr<Interaction> first, std::unique_ptr<Interaction> second, bool reacts)
      : first_(std::move(first)), second_(std::move(second)), reacts_(reacts) {}

  bool is_gradient(const Rule& rule) const override { return first_->is_gradient(rule) && second_->is_gradient(rule); }
  bool follows(Mean mean) const override { return first_->follows(mean) && second_->follows(mean); }
  bool needs_positive_gaps() const override { return first_->needs_positive_gaps(); }

  bool couples_anew() const override { return true; }
  bool update_stencils(const double* u) override {
    const bool first = first_->update_stencils(u), second = second_->update_stencils(u);
    return first || second;
  }
  std::vector<std::vector<int>> stencils() const override {
    std::vector<std::vector<int>> all = first_->stencils();
    for (std::vector<int>& own : second_->stencils()) all.push_back(std::move(own));
    return all;
  }

  void initialize(const KnownState& start) override {
    first_->initialize(start);
    second_->initialize(start);
  }
  void begin_step(const KnownState& start, double time, double dt) override {
    first_->begin_step(start, time, dt);
    second_->begin_step(start, time, dt);
  }
  double accept(const AcceptedStep& step) override {
    const double lost = first_->accept(step);
    return lost + second_->accept(step);
  }
  bool has_state() const override { return true; }
  void transfer(Record& record) override {
    const auto transfer = [&](const char* name, Interaction& pass) {
      const Record::Section section(record, name);
      pass.transfer(record);
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
  double energy(const double* u) const override {
    return (reacts_ ? 1 : 0.5) * (first_->energy(u) + second_->energy(u));
  }
  double mean_potential(const Segment& segment) const override {
    return first_->mean_potential(segment) + second_->mean_potential(segment);
  }

  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override {
    return std::min(first_->admissible_step(segment, rule, direction),
                    second_->admissible_step(segment, rule, direction));
  }
  double gap_ratio(const double* from, const double* to) const override {
    return std::max(first_->gap_ratio(from, to), second_->gap_ratio(from, to));
  }
  double rounding(const double* u) const override { return first_->rounding(u) + second_->rounding(u); }
  LowestPoint lowest_point(const double* u) const override { return first_->lowest_point(u); }
  bool is_clear(const double* u) const override { return first_->is_clear(u); }
  LowestPoint passage(const double* from, const double* to) const override { return first_->passage(from, to); }

  void report(const double* u, InteractionReport& report) const override {
    InteractionReport other;
    first_->report(u, report);
    second_->report(u, other);
    report.least_gap = std::min(report.least_gap, other.least_gap);
    if (!reacts_) return;
    for (std::size_t i = 0; i < report.force.size(); ++i) report.force[i] -= other.force[i];
  }
  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    first_->add_nodal_measure(counted, measure);
    second_->add_nodal_measure(counted, measure);
  }
  void add_nodal_pressure(const double* u, double* force) const override {
    first_->add_nodal_pressure(u, force);
    second_->add_nodal_pressure(u, force);
  }
  void lower_nodal_gap(const double* u, double* gap) const override {
    first_->lower_nodal_gap(u, gap);
    second_->lower_nodal_gap(u, gap);
  }
  void set_nodal_normal(const double* u, double* normal) const override {
    first_->set_nodal_normal(u, normal);
    second_->set_nodal_normal(u, normal);
  }

 private:
  class Action final : public TangentAction {
   public:
    Action(std::unique_ptr<TangentAction> first, std::unique_ptr<TangentAction> second)
        : first_(std::move(first)), second_(std::move(second)) {}
    void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart& linear) override {
      first_->linearize(segment, rule, kind, linear);
      second_->linearize(segment, rule, kind, linear);
    }
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
