/// Linear displacements on a mesh of quadratic cells: the coarse space of a two-level method.
#pragma once
#include <cstddef>
#include <vector>

#include "base/tpetra.hpp"
#include "discretization/discretization.hpp"

namespace ixos {

/// The linear cells on the corners of quadratic ones, and the prolongation P from their displacements to those of the
/// quadratic cells: a corner keeps its displacement, a middle node takes the mean of the corners of its edge, face or
/// cell. The rank that owns a fine node owns its coarse one, in the same order, and has all cells around it, so it
/// assembles its rows of P^T W P alone.
///
/// A coarse degree of freedom that moves a constrained fine one is left out: its column of P is zero, and matrices have
/// a row of the identity there. Therefore P moves no constrained degree of freedom, and P^T W P is a Galerkin product.
class CoarseSpace {
 public:
  /// `constrained`: local fine degrees of freedom, ghosts constrained on every rank that sees them. The mesh and the
  /// space must outlive it. Throws std::logic_error if a block is not quadratic. Collective.
  CoarseSpace(const LocalMesh& fine, const DofSpace& fine_space, const std::vector<int>& constrained);

  const LocalMesh& mesh() const { return coarse_.mesh(); }
  const DofSpace& space() const { return coarse_.space(); }
  const Pattern& pattern() const { return coarse_.pattern(); }
  /// Returns the number of values of a matrix in the layout of Pattern::create_matrix.
  std::size_t values() const;
  /// Returns the number of local fine degrees of freedom.
  std::size_t fine_local() const { return static_cast<std::size_t>(fine_space_.local()); }
  /// Returns the local coarse node of a fine corner; -1 for a middle node.
  int number(int fine_node) const { return number_[static_cast<std::size_t>(fine_node)]; }
  /// Returns the local coarse degrees of freedom that are left out.
  const std::vector<int>& left_out() const { return left_out_; }

  /// Sets fine = P coarse, and coarse = P^T fine: owned vectors of one column. Collective.
  void prolongate(const Vector& coarse, Vector& fine) const;
  void restrict_to_coarse(const Vector& fine, Vector& coarse) const;

  /// Adds P^T D P for the diagonal D of a local fine array, ghosts included. Does not leave out any row.
  void add_diagonal(const double* fine, double* values) const;
  /// Replaces the rows and columns of left-out degrees of freedom by `diagonal` I.
  void leave_out(double diagonal, double* values) const;

 private:
  /// A corner that moves a node, and how much.
  struct Share {
    int corner;
    double weight;
  };
  static LocalMesh coarse_mesh(const LocalMesh& fine, const DofSpace& fine_space, std::vector<int>& number);
  void find_shares(const LocalMesh& fine);
  void find_left_out(const std::vector<int>& constrained);
  const Share* shares_begin(std::size_t node) const { return shares_.data() + first_share_[node]; }
  const Share* shares_end(std::size_t node) const { return shares_.data() + first_share_[node + 1]; }

  const DofSpace& fine_space_;
  std::size_t dimension_;
  std::vector<int> number_;  ///< by local fine node
  Discretization coarse_;
  std::vector<std::size_t> first_share_;  ///< by local fine node
  std::vector<Share> shares_;             ///< of all local fine nodes, one after the other
  std::vector<int> left_out_;
  std::vector<char> is_left_out_;                    ///< by local coarse degree of freedom
  mutable std::vector<double> on_coarse_, on_fine_;  ///< scratch, local
};

}  // namespace ixos
