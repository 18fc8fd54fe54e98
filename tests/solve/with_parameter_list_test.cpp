#include "solve/with_parameter_list.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterListAcceptor.hpp>
#include <Teuchos_ParameterListExceptions.hpp>
#include <Teuchos_StandardParameterEntryValidators.hpp>

namespace ixos {
namespace {

/// Thyra's factories take lists by the same interface.
class Factory final : public WithParameterList<Teuchos::ParameterListAcceptor> {
 public:
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters() const override {
    const auto valid = Teuchos::parameterList("Valid");
    valid->set("Degree", 3, "", Teuchos::rcp(new Teuchos::EnhancedNumberValidator<int>(1, 100)));
    valid->set("Ratio", 20.0);
    return valid;
  }
};

TEST(WithParameterListSerialTest, AListIsKeptAndFilledIn) {
  Factory factory;
  EXPECT_TRUE(factory.getParameterList().is_null());
  EXPECT_TRUE(factory.getNonconstParameterList().is_null());
  const auto list = Teuchos::parameterList("Mine");
  list->set("Degree", 5);
  factory.setParameterList(list);
  EXPECT_EQ(factory.getNonconstParameterList(), list) << "the list itself, no copy";
  EXPECT_EQ(factory.getParameterList()->get<int>("Degree"), 5);
  EXPECT_EQ(list->get<double>("Ratio"), 20.0);
}

TEST(WithParameterListSerialTest, AListIsHandedBackOnce) {
  Factory factory;
  const auto list = Teuchos::parameterList("Mine");
  factory.setParameterList(list);
  EXPECT_EQ(factory.unsetParameterList(), list);
  EXPECT_TRUE(factory.getParameterList().is_null());
  EXPECT_TRUE(factory.unsetParameterList().is_null());
}

TEST(WithParameterListSerialTest, AListThatIsNotValidIsRefusedAndTheOldOneStays) {
  Factory factory;
  const auto list = Teuchos::parameterList("Mine"), unknown = Teuchos::parameterList("Unknown name"),
             type = Teuchos::parameterList("Wrong type"), range = Teuchos::parameterList("Out of range");
  factory.setParameterList(list);
  unknown->set("Degre", 5);
  type->set("Ratio", 20);
  range->set("Degree", 0);
  EXPECT_THROW(factory.setParameterList(unknown), Teuchos::Exceptions::InvalidParameterName);
  EXPECT_THROW(factory.setParameterList(type), Teuchos::Exceptions::InvalidParameterType);
  EXPECT_THROW(factory.setParameterList(range), Teuchos::Exceptions::InvalidParameterValue);
  EXPECT_EQ(factory.getNonconstParameterList(), list);
}

}  // namespace
}  // namespace ixos
