/// The parameter list that the factories of factorisations share. Included by lib/solve only.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <utility>

#include "solve/factorization.hpp"

namespace ixos {

/// A Thyra factory, of the interface `Base`, whose list is factorization_parameters().
template <class Base>
class WithFactorizationList : public Base {
  using List = Teuchos::RCP<Teuchos::ParameterList>;

 public:
  /// Throws Teuchos' exceptions where the list is not valid.
  void setParameterList(const List& list) override {
    list->validateParametersAndSetDefaults(*getValidParameters());
    list_ = list;
  }
  List getNonconstParameterList() override { return list_; }
  List unsetParameterList() override { return std::exchange(list_, Teuchos::null); }
  Teuchos::RCP<const Teuchos::ParameterList> getParameterList() const override { return list_; }
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters() const override { return factorization_parameters(); }

 protected:
  /// A factorisation of the chosen type for `matrix`, renewed: `kept`, where that is one of the same matrix object.
  void renew(const Teuchos::RCP<const CrsMatrix>& matrix, KeptFactorization& kept) const {
    kept.renew(matrix, list_.is_null() ? "CHOLMOD" : list_->get<std::string>("Solver Type", "CHOLMOD"));
  }

 private:
  List list_;
};

}  // namespace ixos
