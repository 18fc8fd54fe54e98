/// The linear solver that a scene gets when it asks for none.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>

namespace ixos {

/// The properties on which the choice depends.
struct ProblemSize {
  int dimension = 2;
  long long dofs = 0;
  int ranks = 1;
  std::string asymmetry{};    ///< what makes the tangent unsymmetric, in words; empty if it is symmetric
  std::string matrix_only{};  ///< what cannot be applied without a matrix, in words; empty if there is no such part
  double width = 1e300;       ///< mean_level_width() of the mesh
  double aspect = 1;          ///< the largest aspect ratio of a cell, see MeshQuality
  double stiffness = 1e300;   ///< of the longest step: elastic forces to inertia in the tangent, the largest K_ii/M_ii
  bool quadratic = false;     ///< all cells are
  bool refined = false;       ///< linear cells have coarse cells, see Refinement
  std::string fine_only{};    ///< what has no Galerkin product on coarse cells, in words; empty if all have one
};

/// Fills in a scene's "Linear Solver" list if its "Linear Solver Type" is "Automatic" or missing. Same on all ranks.
/// - Chooses a sparse factorisation when that is cheap (one rank: to 300,000 degrees of freedom in 2D, 30,000 in 3D;
///   several ranks: to 50,000 in 2D, 5,000 in 3D). To 2,000 degrees of freedom, and for narrow bands (a width of at
///   most 40 nodes in 2D, 25 in 3D), each tangent gets its own, by Band. Other factorisations are kept to precondition
///   CG.
/// - Beyond, in 3D, chooses MUMPS in single precision on all ranks if the body is slender (a width of at most 600
///   nodes, to 2,000,000), else MueLu.
/// - In 3D, from 2,000 on, if steps are short (a stiffness of at most 250), chooses CG with Chebyshev's polynomial,
///   without a matrix.
/// - Compact bodies in 3D, with cells of an aspect ratio of at most 6, get the two-level cycle on one rank: those of
///   quadratic cells from 2,000 on, those of linear cells that have coarse cells from 5,000 on. A body is compact if it
///   is up to five times as long as wide.
/// - Large meshes in 3D of quadratic cells, or of linear ones that have coarse cells, get the two-level cycle in place
///   of MueLu, without a fine matrix. Its coarse matrix is factorised if that is cheap, else it gets MueLu.
/// - Large tangents in 3D are matrix-free. In 3D Band makes the factors that precondition CG to a width of 60 nodes, on
///   one rank MUMPS in single precision those of wider bodies.
/// - If the list asks for Belos or MueLu, fills in its missing entries with settings that suit elasticity.
/// - An unsymmetric tangent gets LU in place of Cholesky and GMRES in place of CG.
/// Throws InputError, with the list path and the cause, if the list asks for a solver of symmetric matrices and the
/// tangent is not symmetric (as preconditioners Band and CHOLMOD are accepted), or for "Matrix-Free" or "Two-Level"
/// that is not possible.
Teuchos::ParameterList completed_linear_solver(const Teuchos::ParameterList& user, const ProblemSize& size);

/// Returns whether completed_linear_solver() may use the coarse cells of linear cells: a scene's list asks for them, or
/// leaves the choice.
bool may_use_coarse_cells(const Teuchos::ParameterList& user, int dimension, long long dofs, int ranks);

/// Throw InputError, for "Two-Level", if the mesh has neither quadratic cells nor coarse cells, or if a term has no
/// Galerkin product on coarse cells.
void require_coarse_cells(const ProblemSize& size);
void require_coarse_terms(const ProblemSize& size);

/// Returns whether a "Preconditioner Type" never asks a matrix-free tangent for its matrix.
bool preconditions_without_matrix(const std::string& type);

/// Returns a completed list in words: "Belos (Pseudo Block CG), preconditioner Direct (CHOLMOD), tangents assembled".
std::string linear_solver_in_words(const Teuchos::ParameterList& completed);

}  // namespace ixos
