/// The parameter list that the factories of factorisations share. Included by lib/solve only.
#pragma once
#include <string>

#include "solve/direct/factorization.hpp"
#include "solve/with_parameter_list.hpp"

namespace ixos {

/// A Thyra factory, of the interface `Base`, whose list is factorization_parameters().
template <class Base>
class WithFactorizationList : public WithParameterList<Base> {
 public:
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters() const override { return factorization_parameters(); }

 protected:
  /// Renews `kept`, a factorisation of the chosen type for `matrix`, see KeptFactorization::renew().
  void renew(const Teuchos::RCP<const CrsMatrix>& matrix, KeptFactorization& kept) const {
    kept.renew(matrix, this->list_or_defaults()->template get<std::string>("Solver Type"));
  }
};

}  // namespace ixos
