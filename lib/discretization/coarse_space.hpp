/// Linear displacements on the corners of quadratic cells, or on the coarse cells of linear ones: the coarse space of a
/// two-level method.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "base/tpetra.hpp"
#include "discretization/discretization.hpp"

namespace ixos {

/// The linear cells on the corners of quadratic ones, or the coarse cells of linear ones (see Refinement), and the
/// prolongation P from their displacements to those of the fine cells: a corner keeps its displacement, another node
/// takes that of the linear cell at its place: a middle node the mean of the corners of its edge, face or cell. The
/// rank that owns a fine node owns its coarse one, in the same order.
/// - On quadratic cells a rank has all cells around its coarse nodes, so it assembles its rows of P^T W P alone.
/// - Of a coarse cell's fine cells a rank may have some only. Each rank adds its own fine cells to the rows of all its
///   local coarse nodes, and the ranks sum them.
///
/// Where quadratic cells have hanging nodes, a corner of finer cells in the middle of a coarser one's edge or face is
/// tied to the corners of that, see hanging_corners(), so that the linear cells conform. Where several levels meet,
/// some such corners are coarse nodes of their own: there the Galerkin product is that of cells that come apart, a
/// preconditioner all the same.
///
/// A coarse degree of freedom that moves a constrained fine one is left out: its column of P is zero, and matrices have
/// a row of the identity there. Therefore P moves no constrained degree of freedom, and P^T W P is a Galerkin product.
class CoarseSpace {
 public:
  /// `constrained`: local fine degrees of freedom, ghosts constrained on every rank that sees them. The mesh and the
  /// space must outlive it. Throws std::logic_error if linear cells have no coarse cells. Collective.
  CoarseSpace(const LocalMesh& fine, const DofSpace& fine_space, const std::vector<int>& constrained);

  const LocalMesh& mesh() const { return coarse_.mesh(); }
  const DofSpace& space() const { return coarse_.space(); }
  /// Returns the layout of values to which terms add: of owned rows, or of all local ones (see above).
  const Pattern& pattern() const { return local_rows_ ? *local_rows_ : coarse_.pattern(); }
  /// Returns the number of values in that layout.
  std::size_t values() const { return pattern().values(); }
  /// Returns a matrix of owned rows, values zero.
  Teuchos::RCP<CrsMatrix> create_matrix() const { return coarse_.pattern().create_matrix(space()); }
  /// Returns P^T W P: `add` adds to values of pattern(), which are zero before. Left-out degrees of freedom get rows
  /// and columns of `diagonal` I. Collective.
  Teuchos::RCP<CrsMatrix> matrix(const std::function<void(double*)>& add, double diagonal) const;
  /// Returns the number of local fine degrees of freedom.
  std::size_t fine_local() const { return static_cast<std::size_t>(fine_space_.local()); }
  /// Returns the local coarse node of a fine corner, which may be tied; -1 for a middle node.
  int number(int fine_node) const { return number_[static_cast<std::size_t>(fine_node)]; }
  /// Returns the local coarse degrees of freedom that are left out.
  const std::vector<int>& left_out() const { return left_out_; }

  /// Sets fine = P coarse, and coarse = P^T fine: owned vectors of one column. Collective.
  void prolongate(const Vector& coarse, Vector& fine) const;
  void restrict_to_coarse(const Vector& fine, Vector& coarse) const;

  /// Adds P^T D P for the diagonal D of a local fine array, ghosts included. Does not leave out any row.
  void add_diagonal(const double* fine, double* values) const;

  /// A local coarse node, not tied, that moves a fine one, and how much.
  struct Share {
    int corner;
    double weight;
  };
  /// Return the range of the shares of a local fine node, by ascending corner.
  const Share* shares_begin(std::size_t node) const { return shares_.data() + first_share_[node]; }
  const Share* shares_end(std::size_t node) const { return shares_.data() + first_share_[node + 1]; }

 private:
  static LocalMesh coarse_mesh(const LocalMesh& fine, const DofSpace& fine_space, std::vector<int>& number);
  static LocalMesh coarse_cells(const LocalMesh& fine, std::vector<int>& number);
  void find_shares(const LocalMesh& fine);
  std::vector<Share> resolved(std::vector<Share> shares) const;
  void take_shares(const LocalMesh& fine);
  void find_left_out(const std::vector<int>& constrained);
  /// Replaces the rows and columns of left-out degrees of freedom by `diagonal` I, in owned rows.
  void leave_out(double diagonal, double* values) const;

  const DofSpace& fine_space_;
  std::size_t dimension_;
  std::vector<int> number_;  ///< by local fine node
  Discretization coarse_;
  std::unique_ptr<const Pattern> local_rows_;  ///< null if owned rows suffice
  std::vector<std::size_t> first_share_;       ///< by local fine node
  std::vector<Share> shares_;                  ///< of all local fine nodes, one after the other
  std::vector<int> left_out_;
  std::vector<char> is_left_out_;                    ///< by local coarse degree of freedom
  mutable std::vector<double> on_coarse_, on_fine_;  ///< scratch, local
};

}  // namespace ixos
