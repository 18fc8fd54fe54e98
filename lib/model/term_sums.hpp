/// Sums over the terms of a model.
#pragma once
#include <memory>
#include <vector>

#include "model/model.hpp"

namespace ixos {

/// The points that force terms keep of their last force, parallel to Model::force_terms(); null for terms that keep
/// nothing.
using KeptForces = std::vector<std::unique_ptr<KeptPoints>>;

/// Forces, tangents and potentials of all terms together. The model must outlive it. Arrays are local. None of the
/// functions communicates, unless it says so.
class TermSums {
 public:
  explicit TermSums(const Model& model) : model_(model) {}

  /// Sets f to the rule's force of that part's terms. Returns false if the state is inadmissible on this rank.
  bool force(Part part, const Segment& segment, const Rule& rule, double* f) const;
  /// Returns a place for what force_and_keep() keeps.
  KeptForces create_kept() const;
  /// See ForceTerm::add_force_and_keep, add_kept_tangent.
  bool force_and_keep(Part part, const Segment& segment, const Rule& rule, KeptForces& kept, double* f) const;
  void add_kept_tangent(Part part, const Segment& segment, const Rule& rule, Tangent kind, const KeptForces& kept,
                        double* values) const;
  /// Adds the part's tangent. `kind` concerns interactions only.
  void add_tangent(Part part, const Segment& segment, const Rule& rule, Tangent kind, double* values) const;
  /// Returns an action of each term of the part; null if a term offers none.
  std::vector<std::unique_ptr<TangentAction>> actions(Part part) const;
  /// Returns, for the elastic term of each block, its share of mass M + damping C.
  std::vector<LinearPart> linear_parts(double mass, double damping) const;
  /// See ForceTerm::add_row_sums. Rows of masters get those of tied nodes too; the magnitudes of a tied column's
  /// weights count as 1, see StableStep.
  bool add_row_sums(Part part, const Segment& segment, double* sums) const;

  /// Call the RateTerm functions of these names for all rate terms. Without rate terms they do nothing.
  bool has_rates() const { return !model_.rate_terms().empty(); }
  void add_rate_force(const Place& at, double* f) const;
  void add_rate_tangent(const Place& at, double* values) const;
  double rate_potential(const Place& at) const;
  void add_rate_force_at(double factor, const double* u, const double* v, double* f) const;
  void add_rate_tangent_at(double by_velocity, double by_displacement, const double* u, const double* v,
                           double* values) const;
  void add_rate_row_sums(const double* u, double* sums) const;
  /// Returns whether all rate terms but the model's damping are diagonal, and the sum of the diagonals of those that
  /// are, a local array; empty if none is.
  bool has_diagonal_rates() const;
  std::vector<double> rate_diagonal(double factor) const;

  /// Returns this rank's sum of ForceTerm::potential over that part's terms, except interactions that follow a mean in
  /// closed form in place of the rule's points [E0 L0^D].
  double potential(Part part, const Rule& rule, const Place& at) const;
  /// Returns this rank's sum of Interaction::mean_potential over the interactions that follow the exact mean, by that
  /// rule or in place of it [E0 L0^D].
  double mean_potential(const Segment& segment, const Rule& rule) const;
  /// Returns this rank's sum of Interaction::rounding over the interactions.
  double rounding(const Place& at) const;

  /// Returns the largest admissible step along `direction`, over all interactions and ranks. Collective.
  double admissible_step(const Segment& segment, const Rule& interaction, const double* direction) const;
  /// Returns the largest Admissibility::gap_ratio. Collective.
  double gap_ratio(const Segment& way) const;
  /// Returns the sum of ObstacleMotion::work() [E0 L0^D]. Collective.
  double obstacle_work(const Segment& segment, const Rule& rule) const;

 private:
  void condense_row_sums(double* sums) const;
  template <class Visit>
  void for_each(Part part, const Visit& visit) const;

  const Model& model_;
};

/// Adds value I to matrix values in the layout of Pattern::create_matrix.
void add_to_diagonal(const Pattern& pattern, int dimension, double value, double* values);

}  // namespace ixos
