/// The linear solver that a scene gets when it asks for none.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>

namespace ixos {

/// What the choice depends on.
struct ProblemSize {
  int dimension = 2;
  long long dofs = 0;
  int ranks = 1;
  bool symmetric = true;     ///< the tangent
  bool matrix_free = true;   ///< do all terms offer it without a matrix?
  double width = 1e300;      ///< mean_level_width() of the mesh; asked for in three dimensions only
  double stiffness = 1e300;  ///< of the longest step: elastic forces to inertia in the tangent, the largest K_ii/M_ii
};

/// Fills in a scene's "Linear Solver" list where its "Linear Solver Type" is "Automatic" or missing: sparse
/// factorisation where it is cheap (one rank: to 300,000 degrees of freedom in 2D, 30,000 in 3D; several ranks: to
/// 50,000 in 2D, 5,000 in 3D), from 2,000 on as the kept preconditioner of CG; beyond, in 3D, MUMPS in single precision
/// on all ranks where the body is slender (a width of at most 600 nodes, to 2,000,000), else MueLu. In 3D, from 2,000
/// on, where steps are short (a stiffness of at most 250), CG with Chebyshev's polynomial, without a matrix. Large
/// tangents in 3D are matrix-free. On one rank a factorisation that preconditions in 3D is always MUMPS' in single
/// precision. Where Belos or MueLu is asked for, what the list does not say of them is filled in with settings that
/// suit elasticity. An unsymmetric tangent gets LU in place of Cholesky and GMRES in place of CG; asking for CHOLMOD or
/// a CG method is then refused (InputError), but as a preconditioner CHOLMOD serves. Same on all ranks.
Teuchos::ParameterList completed_linear_solver(const Teuchos::ParameterList& user, const ProblemSize& size);

/// A completed list in words: "Belos (Pseudo Block CG), preconditioner Direct (CHOLMOD), tangents assembled".
std::string linear_solver_in_words(const Teuchos::ParameterList& completed);

}  // namespace ixos
