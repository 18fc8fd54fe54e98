/// The common code of Thyra factories that have a parameter list. Included by lib/solve only.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <utility>

namespace ixos {

/// A Thyra factory of the interface `Base` that keeps its list; getValidParameters() defines its valid entries. A
/// factory that leaves it null is configured at construction, and reads nothing of the list.
template <class Base>
class WithParameterList : public Base {
  using List = Teuchos::RCP<Teuchos::ParameterList>;

 public:
  /// Throws Teuchos' exceptions if the list is not valid.
  void setParameterList(const List& list) override {
    if (const auto valid = getValidParameters(); nonnull(valid)) list->validateParametersAndSetDefaults(*valid);
    list_ = list;
  }
  List getNonconstParameterList() override { return list_; }
  List unsetParameterList() override { return std::exchange(list_, Teuchos::null); }
  Teuchos::RCP<const Teuchos::ParameterList> getParameterList() const override { return list_; }
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters() const override { return Teuchos::null; }

 protected:
  /// Returns the list, or the defaults if none was set.
  Teuchos::RCP<const Teuchos::ParameterList> list_or_defaults() const {
    return nonnull(list_) ? Teuchos::RCP<const Teuchos::ParameterList>(list_) : this->getValidParameters();
  }

 private:
  List list_;
};

}  // namespace ixos
