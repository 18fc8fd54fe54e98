#include "solve/loaded/two_level_preconditioner.hpp"

#include <Teuchos_StandardParameterEntryValidators.hpp>
#include <Thyra_DefaultLinearOpSource.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <algorithm>
#include <vector>

#include "base/agreement.hpp"
#include "solve/coarsenable_operator.hpp"
#include "solve/direct/direct_preconditioner.hpp"
#include "solve/iterative/chebyshev_polynomial.hpp"
#include "solve/iterative/rigid_body_modes.hpp"
#include "solve/loaded/muelu_factory.hpp"
#include "solve/operator_preconditioner.hpp"
#include "solve/tpetra_preconditioner.hpp"

namespace ixos {
namespace {

/// The largest eigenvalue must not exceed its estimate: the cycle would not be positive definite.
constexpr double margin = 1.1;

Teuchos::RCP<PreconditionerFactory> coarse_factory(const Teuchos::ParameterList& list, const CoarseSpace& space) {
  Teuchos::RCP<PreconditionerFactory> factory;
  const auto type = list.get<std::string>("Type");
  const auto own = Teuchos::rcp(new Teuchos::ParameterList);
  if (list.isSublist(type)) own->setParameters(list.sublist(type));
  if (type == "Direct") {
    factory = Teuchos::rcp(new DirectPreconditionerFactory);
  } else {
    own->set("Nullspace", rigid_body_modes(space.mesh(), space.space(), space.left_out()));
    own->set("Coordinates", node_coordinates(space.mesh(), space.space().comm()));
    factory = make_muelu_factory();
  }
  factory->setParameterList(own);
  return factory;
}

class TwoLevel final : public TpetraPreconditioner {
 public:
  void initialize(const Teuchos::RCP<const Thyra::LinearOpBase<double>>& op, const Teuchos::ParameterList& list) {
    op_ = op;
    fine_ = Extract::getConstTpetraOperator(op);
    const auto& coarsenable = dynamic_cast<const CoarsenableOperator&>(*fine_);
    coarse_ = &coarsenable.coarse_space();
    if (smoother_.waits())
      restore_matrix();
    else
      matrix_ = coarsenable.coarse_matrix();
    smoother_.initialize(fine_, {list.get<int>("Degree"), list.get<double>("Eigenvalue Ratio"), margin});
    const auto factory = coarse_factory(list.sublist("Coarse"), *coarse_);
    const Teuchos::RCP<const Operator> matrix = matrix_;
    space_ = vector_space(matrix_->getRowMap());
    solver_ = factory->createPrec();
    initialize_preconditioner(*factory, true, Thyra::defaultLinearOpSource(const_linear_op(matrix, space_)), *solver_);
  }

  void transfer(Record& record) override {
    std::vector<double> values = loaded_;
    if (nonnull(matrix_) && !smoother_.waits()) {
      const auto present = matrix_->getLocalMatrixHost().values;
      values.assign(present.data(), present.data() + present.extent(0));
    }
    smoother_.transfer(record);
    record.share("coarse matrix", values);
    if (record.loading()) loaded_ = std::move(values);
  }

 private:
  void restore_matrix() {
    matrix_ = coarse_->create_matrix();
    const auto values = matrix_->getLocalMatrixHost().values;
    together<InputError>(matrix_->getComm(), [&] {
      if (loaded_.size() != values.extent(0)) throw InputError("a matrix of the checkpoint has a different size");
    });
    std::copy(loaded_.begin(), loaded_.end(), values.data());
    loaded_.clear();
  }

  void precondition(const MultiVector& b, MultiVector& target, double alpha, double beta) const override {
    MultiVector z(smoother_(b), Teuchos::Copy), residual(b.getMap(), b.getNumVectors(), false);
    subtract_product(b, z, residual);
    correct(residual, z);
    subtract_product(b, z, residual);
    z.update(1.0, smoother_(residual), 1.0);
    target.update(alpha, z, beta);
  }

  /// Sets residual = b - W z.
  void subtract_product(const MultiVector& b, const MultiVector& z, MultiVector& residual) const {
    residual.assign(b);
    fine_->apply(z, residual, Teuchos::NO_TRANS, -1.0, 1.0);
  }

  /// Adds P A^-1 P^T residual to z.
  void correct(const MultiVector& residual, MultiVector& z) const {
    const auto columns = residual.getNumVectors();
    MultiVector known(matrix_->getRowMap(), columns, false), found(matrix_->getRowMap(), columns);
    for (std::size_t j = 0; j < columns; ++j)
      coarse_->restrict_to_coarse(*residual.getVector(j), *known.getVectorNonConst(j));
    const auto from =
        Thyra::createConstMultiVector<double, LocalId, GlobalId, Node>(Teuchos::rcpFromRef(known), space_);
    const auto to = Thyra::createMultiVector<double, LocalId, GlobalId, Node>(Teuchos::rcpFromRef(found), space_);
    Thyra::apply(*solver_->getUnspecifiedPrecOp(), Thyra::NOTRANS, *from, to.ptr());
    Vector step(z.getMap());
    for (std::size_t j = 0; j < columns; ++j) {
      coarse_->prolongate(*found.getVector(j), step);
      z.getVectorNonConst(j)->update(1.0, step, 1.0);
    }
  }

  Teuchos::RCP<const Operator> fine_;
  ChebyshevPolynomial smoother_;
  const CoarseSpace* coarse_ = nullptr;  ///< the operator's
  Teuchos::RCP<CrsMatrix> matrix_;       ///< on it
  VectorSpace space_;
  Teuchos::RCP<Thyra::PreconditionerBase<double>> solver_;
  std::vector<double> loaded_;  ///< values of the matrix from a checkpoint, for the next operator
};

}  // namespace

Teuchos::RCP<const Teuchos::ParameterList> TwoLevelPreconditionerFactory::getValidParameters() const {
  const auto list = Teuchos::rcp(new Teuchos::ParameterList("Two-Level"));
  list->set("Degree", 2, "Degree of the smoother's polynomial: one product with the tangent less, twice a cycle.",
            Teuchos::rcp(new Teuchos::EnhancedNumberValidator<int>(1, 100)));
  list->set("Eigenvalue Ratio", 7.0, "Largest ratio of the eigenvalues at the two ends of the smoother's interval [-].",
            Teuchos::rcp(new Teuchos::EnhancedNumberValidator<double>(1.1, 1e6)));
  Teuchos::ParameterList& coarse = list->sublist("Coarse");
  coarse.set("Type", "Direct", "Preconditioner of the linear cells' matrix.",
             Teuchos::rcp(new Teuchos::StringValidator(Teuchos::tuple<std::string>("MueLu", "Direct"))));
  coarse.sublist("MueLu").disableRecursiveValidation();
  coarse.sublist("Direct").disableRecursiveValidation();
  return list;
}

bool TwoLevelPreconditionerFactory::isCompatible(const Source& source) const {
  return nonnull(Teuchos::rcp_dynamic_cast<const CoarsenableOperator>(Extract::getConstTpetraOperator(source.getOp())));
}

Teuchos::RCP<TwoLevelPreconditionerFactory::Preconditioner> TwoLevelPreconditionerFactory::createPrec() const {
  return wrapped_preconditioner<TwoLevel>();
}

void TwoLevelPreconditionerFactory::initializePrec(const Teuchos::RCP<const Source>& source,
                                                   Preconditioner* preconditioner,
                                                   const Thyra::ESupportSolveUse) const {
  const auto list = list_or_defaults();
  unwrapped<TwoLevel>(*preconditioner).initialize(source->getOp(), *list);
}

}  // namespace ixos
