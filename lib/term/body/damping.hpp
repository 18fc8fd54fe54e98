/// Rayleigh damping.
#pragma once
#include <memory>
#include <vector>

#include "discretization/pattern.hpp"
#include "term/body/mass.hpp"
#include "term/force_term.hpp"
#include "term/rate_term.hpp"

namespace ixos {

/// The constant matrix C = sum over blocks of alpha_1 M + alpha_2 K_el(0), rows of owned nodes. alpha_1 in 1/T0,
/// alpha_2 in T0. It exists only if a material asks for damping. The stiffness part is not objective: it damps
/// finite rigid rotations. Its force in a stage is C times the stage's damping row.
class Damping final : public RateTerm {
 public:
  /// `local`: local degrees of freedom.
  Damping(const Pattern& pattern, int dimension, int local);

  void add_mass(double alpha_1, std::unique_ptr<Mass> mass);
  /// The term must outlive the damping.
  void add_stiffness(double alpha_2, const ForceTerm& term);
  /// Applies C from the terms' actions, and assembles it anew at each add_to(): for models whose tangent is applied
  /// without a matrix too. Without this call the matrix is made at the first use, and cached.
  void do_without_matrix();

  void place(const Pattern& pattern) override;
  bool is_gradient(RateForm) const override { return true; }
  void begin_stage(const StageStart& start, StepMemories& step) const override;
  void add_force(const Place& at, double* f) const override;
  void add_tangent(const Place& at, double* values) const override;
  double potential(const Place& at) const override;
  void add_force_at(double factor, const double* u, const double* v, double* f) const override;
  void add_tangent_at(double by_velocity, double by_displacement, const double* u, const double* v,
                      double* values) const override;
  bool is_diagonal() const override { return false; }
  /// Needs the matrix.
  void add_row_sums(const double* u, double* sums) const override;
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override;

  /// Adds factor C x to y: x local, y the rows of owned nodes.
  void multiply_add(double factor, const double* x, double* y) const;
  /// Adds to y factor times the part of C that is mass, sum alpha_1 M x.
  void multiply_add_mass(double factor, const double* x, double* y) const;
  /// Adds to d factor times the diagonal of that part, rows of owned nodes.
  void add_mass_diagonal(double factor, double* d) const;
  /// Adds factor C to values, in the layout of Pattern::create_matrix.
  void add_to(double factor, double* values) const;

 protected:
  std::unique_ptr<StepMemory> create_memory() const override;

 private:
  struct Memory;
  struct MassPart {
    double alpha;
    std::unique_ptr<Mass> mass;
  };
  struct StiffnessPart {
    double alpha;
    const ForceTerm* term;
    std::unique_ptr<TangentAction> action;  ///< null if the matrix is kept
  };
  /// Returns the owned rows' part of x . C y.
  double work(const std::vector<double>& x, const double* y) const;
  const Memory& memory(const StepMemories* step) const;
  /// Sets row_ to dt times the velocity that C multiplies.
  void evaluate_row(const Place& at) const;
  void multiply_add_matrix(double factor, const double* x, double* y) const;
  void assemble(double factor, double* values) const;
  const std::vector<double>& matrix() const;

  const Pattern& pattern_;
  std::size_t dimension_;
  std::vector<double> rest_;  ///< the undeformed body, a local array of zeros
  std::vector<MassPart> masses_;
  std::vector<StiffnessPart> stiffnesses_;
  bool keeps_matrix_ = true;
  mutable std::vector<double> matrix_;         ///< values, empty before the first use
  mutable std::vector<double> product_, row_;  ///< scratch
};

}  // namespace ixos
