/// The common code of Thyra factories that have a parameter list. Included by lib/solve only.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <utility>

namespace ixos {

/// A Thyra factory of the interface `Base` that keeps its list; getValidParameters() defines its valid entries.
template <class Base>
class WithParameterList : public Base {
  using List = Teuchos::RCP<Teuchos::ParameterList>;

 public:
  /// Throws Teuchos' exceptions if the list is not valid.
  void setParameterList(const List& list) override {
    list->validateParametersAndSetDefaults(*this->getValidParameters());
    list_ = list;
  }
  List getNonconstParameterList() override { return list_; }
  List unsetParameterList() override { return std::exchange(list_, Teuchos::null); }
  Teuchos::RCP<const Teuchos::ParameterList> getParameterList() const override { return list_; }

 protected:
  /// Returns the list, or the defaults if none was set.
  Teuchos::RCP<const Teuchos::ParameterList> list_or_defaults() const {
    return nonnull(list_) ? Teuchos::RCP<const Teuchos::ParameterList>(list_) : this->getValidParameters();
  }

 private:
  List list_;
};

}  // namespace ixos
