// Tests of the lines that begin assignments.
#include "parameters/assignments.hpp"

#include <gtest/gtest.h>

#include "parameters/one_of.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/validation.hpp"

namespace ixos {
namespace {

TEST(AssignmentsTest, AreALineForEachParameterOrForEachOfItsWords) {
  Teuchos::ParameterList valid;
  valid.set("Size", 1.0);
  valid.set("Kind", std::string("A"), "", one_of({"A", "B C"}));
  valid.set("On", true);
  valid.sublist("Things").sublist(any_name).set("Count", 1);
  mark_free_form(valid.sublist("Solver"));
  const std::vector<std::string> lines{
      "Size=<double>", "Kind=A", "Kind=B C", "On=true", "On=false", "Things/<any name>/Count=<int>", "Solver/"};
  EXPECT_EQ(assignments(valid), lines);
}

}  // namespace
}  // namespace ixos
