/// The solvers that are loaded when a scene asks for them.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <Thyra_LinearOpWithSolveFactoryBase.hpp>
#include <Thyra_PreconditionerFactoryBase.hpp>
#include <memory>

namespace ixos {

class Factorization;

/// Makes Thyra's factories from a list of linear solvers. The factories refer to the builder, which must outlive them.
class SolverBuilder {
 public:
  virtual ~SolverBuilder() = default;
  virtual Teuchos::RCP<Thyra::LinearOpWithSolveFactoryBase<double>> solver() const = 0;
  virtual Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> preconditioner() const = 0;
};

/// The contents of the library ixos_solvers (lib/solve/loaded). It brings some forty libraries of Trilinos along, for
/// which the loader takes a twentieth of a second. A run that factorises its matrices needs none of them.
struct SolverLibrary {
  /// Makes the builder of a Stratimikos list, with Ixos' own solvers and preconditioners, MueLu and Ifpack2 added.
  /// Throws what Stratimikos throws if it refuses the list.
  std::unique_ptr<SolverBuilder> (*stratimikos)(const Teuchos::ParameterList& list);
  /// Makes MUMPS (Amestoy, Duff, L'Excellent and Koster 2001): symmetric matrices, L D L^T without pivoting, on all
  /// ranks. On several ranks it decides in the order in which messages arrive: results repeat up to rounding only. In
  /// single precision it takes half the memory and time: as a preconditioner, not as a solver.
  std::unique_ptr<Factorization> (*mumps)(bool single_precision);
};

/// Returns the library, which the first call loads from the folder of libixos, or from two folders further up where
/// libixos is one of several builds for several processors. Throws FileError if it cannot be loaded.
const SolverLibrary& solver_library();

}  // namespace ixos
