#include "scene/read/newton_options.hpp"

#include <gtest/gtest.h>

#include "parameters/validation.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;

NewtonOptions read(const ParameterList& user) {
  ParameterList valid;
  declare_newton(valid);
  const ParameterList complete = validated(user, valid);
  return read_newton(SceneNode(complete, "Nonlinear Solver"));
}

TEST(NewtonOptionsTest, AnEmptyListGivesTheDefaultsOfTheStruct) {
  const NewtonOptions options = read({}), fresh;
  EXPECT_EQ(options.tolerance, fresh.tolerance);
  EXPECT_EQ(options.maximum_iterations, fresh.maximum_iterations);
  EXPECT_EQ(options.snap_iterations, fresh.snap_iterations);
  EXPECT_EQ(options.linear_tolerance, fresh.linear_tolerance);
  EXPECT_EQ(options.nox.numParams(), 0);
}

TEST(NewtonOptionsTest, EveryParameterReachesItsMember) {
  ParameterList user;
  user.set("Tolerance", 1e-6);
  user.set("Linear Tolerance", 1e-4);
  user.set("Maximum Iterations", 7);
  user.set("Snap Iterations", 8);
  user.sublist("NOX").sublist("Printing").set("Output Precision", 5);
  const NewtonOptions options = read(user);
  EXPECT_EQ(options.tolerance, 1e-6);
  EXPECT_EQ(options.linear_tolerance, 1e-4);
  EXPECT_EQ(options.maximum_iterations, 7);
  EXPECT_EQ(options.snap_iterations, 8);
  EXPECT_EQ(options.nox.sublist("Printing").get<int>("Output Precision"), 5);
}

}  // namespace
}  // namespace ixos
