/// Springs and dashpots between nodes and places that a motion drives.
#pragma once
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "term/force_term.hpp"
#include "term/rate_term.hpp"
#include "term/support/constraints.hpp"
#include "term/support/loads.hpp"

namespace ixos {

/// A stiffness k [E0 L0^(D-2)] or a damping c [E0 L0^(D-2) T0] of local degrees of freedom, and the displacement
/// w(t) of their other ends. The force on a node is k (w - u) or c (w' - v). Its parts k w and c w' are loads; the
/// terms below add k u and c v, so that every scheme treats them as it treats elasticity, damping and loads.
struct DrivenEnds {
  std::vector<int> dofs;
  std::vector<double> coefficients;       ///< parallel to dofs
  std::shared_ptr<const Constraints> to;  ///< w of the same degrees of freedom
  /// Where globals begin in local arrays, if there are some among the degrees of freedom: of these, one rank alone has
  /// ends, and the tangent is part of the border.
  int first_global = std::numeric_limits<int>::max();
};

/// Returns whether this rank counts a degree of freedom that it has ends of; `owned`: how many it owns.
inline bool counts(const DrivenEnds& ends, std::size_t dof, std::size_t owned) {
  return dof < owned || static_cast<int>(dof) >= ends.first_global;
}

/// Adds factor times the coefficients of globals to the border's block.
void add_to_border(double factor, const DrivenEnds& ends, Border& border);

/// Returns w (and w') as local arrays of that size, zero elsewhere.
std::vector<double> places_of(const DrivenEnds& ends, double time, std::size_t local);
std::vector<double> rates_of(const DrivenEnds& ends, double time, std::size_t local);

/// The term k u. Its energy is sum k u^2/2; stretch_energy() is what the springs store beyond that.
class Springs final : public ForceTerm {
 public:
  Springs(DrivenEnds ends, const Pattern& pattern, std::size_t local);

  Part part() const override { return Part::Elastic; }
  void place(const Pattern& pattern) override;
  bool add_force(const Segment& segment, const Rule& rule, double* f) const override;
  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override;
  void add_border(Border& border) const override { add_to_border(tangent_factor_, ends_, border); }
  std::unique_ptr<TangentAction> create_action() const override;
  bool add_row_sums(const Segment& segment, double* sums) const override;
  double energy(const Place& at) const override;
  bool has_time_derivative(const Rule&) const override { return true; }
  /// The factor of all stiffnesses, 1 at first, of which the load k w is no part.
  std::vector<std::string> parameters() const override { return {"Stiffness Factor"}; }
  bool add_parameter_derivative(std::size_t parameter, const Segment& segment, const Rule& rule,
                                double* f) const override {
    return add_factor_derivative(parameter, segment, rule, f);
  }

  /// The driven work is that of the driven ends, less that of the load k w: the change of stretch_energy().
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override;

  /// Returns this rank's share of sum k (u - w)^2/2 - k u^2/2 [E0 L0^D].
  double stretch_energy(double time, const double* u) const;
  /// Adds the gradient of stretch_energy() by u, -k w, to a local array [E0 L0^(D-1)].
  void add_stretch_gradient(double time, double* f) const;
  const DrivenEnds& ends() const { return ends_; }

 private:
  DrivenEnds ends_;
  std::size_t owned_, local_;          ///< degrees of freedom
  std::vector<std::size_t> places_;    ///< of the diagonal entries, parallel to dofs; ghosts have none
  mutable double tangent_factor_ = 1;  ///< of the last tangent
};

/// The term c v. It dissipates c (v - w')^2.
class Dashpots final : public RateTerm {
 public:
  Dashpots(DrivenEnds ends, const Pattern& pattern, std::size_t local);

  void place(const Pattern& pattern) override;
  bool is_gradient(RateForm) const override { return true; }
  void begin_stage(const StageStart& start, StepMemories& step) const override;
  void add_force(const Place& at, double* f) const override;
  void add_tangent(const Place& at, double* values) const override;
  double potential(const Place& at) const override;
  void add_force_at(double factor, const double* u, const double* v, double* f) const override;
  void add_tangent_at(double by_velocity, double by_displacement, const double* u, const double* v,
                      double* values) const override;
  void add_row_sums(const double* u, double* sums) const override;
  /// The driven work is that of the driven ends, less that of the load c w'.
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override;

  void add_border(Border& border) const override { add_to_border(tangent_factor_, ends_, border); }
  bool is_diagonal() const override { return true; }
  void add_diagonal(double factor, double* d) const override;
  const DrivenEnds& ends() const { return ends_; }

 protected:
  std::unique_ptr<StepMemory> create_memory() const override;

 private:
  struct Memory;
  const Memory& memory(const StepMemories* step) const;
  double dissipated(const AcceptedStep& step, bool relative) const;

  DrivenEnds ends_;
  std::size_t owned_, local_;
  std::vector<std::size_t> places_;
  mutable double tangent_factor_ = 0;  ///< of the last tangent
};

}  // namespace ixos
