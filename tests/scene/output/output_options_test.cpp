#include "scene/output/output_options.hpp"

#include <gtest/gtest.h>

#include "parameters/validation.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;

ParameterList completed(const ParameterList& user) {
  ParameterList valid;
  declare_output(valid);
  return validated(user, valid);
}

OutputOptions read(const ParameterList& user) {
  const ParameterList complete = completed(user);
  return read_output(SceneNode(complete, "Output"));
}

TEST(OutputOptionsTest, AnEmptyListGivesTheDefaultsOfTheStruct) {
  const OutputOptions output = read({}), fresh;
  EXPECT_EQ(output.history_interval, fresh.history_interval);
  EXPECT_EQ(output.fields_interval, fresh.fields_interval);
  EXPECT_EQ(output.fields_format, fresh.fields_format);
  EXPECT_EQ(output.history_time_interval, fresh.history_time_interval);
  EXPECT_EQ(output.fields_time_interval, fresh.fields_time_interval);
  EXPECT_EQ(output.checkpoint.interval, fresh.checkpoint.interval);
  EXPECT_EQ(output.checkpoint.clock_interval, fresh.checkpoint.clock_interval);
  EXPECT_EQ(output.checkpoint.keep, fresh.checkpoint.keep);
  EXPECT_EQ(output.watch.action, fresh.watch.action);
  EXPECT_EQ(output.watch.tolerance, fresh.watch.tolerance);
  EXPECT_EQ(output.energies, fresh.energies);
  EXPECT_EQ(output.momenta, fresh.momenta);
  EXPECT_EQ(output.interaction, fresh.interaction);
  EXPECT_EQ(output.strains, fresh.strains);
  EXPECT_EQ(output.interaction_columns, fresh.interaction_columns);
  EXPECT_TRUE(output.reactions.empty());
  EXPECT_TRUE(output.fields.empty());
  EXPECT_TRUE(output.norms.empty());
  EXPECT_TRUE(output.quantities.empty());
}

TEST(OutputOptionsTest, EveryParameterReachesItsMember) {
  ParameterList user;
  user.set("History Interval", 3);
  user.set("Fields Interval", 4);
  user.set("Fields Format", "HDF5");
  user.set("History Time Interval", 0.5);
  user.set("Fields Time Interval", 0.25);
  user.set("Energies", false);
  user.set("Momenta", false);
  user.set("Interaction", false);
  user.set("Strains", true);
  user.set("Interaction Columns", "Off");
  user.set("Reactions", Teuchos::Array<std::string>(Teuchos::tuple<std::string>("left", "right")));
  user.set("Quantities", Teuchos::Array<std::string>(Teuchos::tuple<std::string>("work", "mean x [1, 2]")));
  user.set("Fields", Teuchos::Array<std::string>(Teuchos::tuple<std::string>("default", "stress")));
  user.set("Norms", Teuchos::Array<std::string>(Teuchos::tuple<std::string>("stress", "velocity")));
  user.sublist("Checkpoint").set("Interval", 5);
  user.sublist("Checkpoint").set("Wall-Clock Interval", 60.0);
  user.sublist("Checkpoint").set("Keep", 7);
  user.sublist("Watch").set("Action", "Resume");
  user.sublist("Watch").set("Tolerance", 1e-6);
  const OutputOptions output = read(user);
  EXPECT_EQ(output.history_interval, 3);
  EXPECT_EQ(output.fields_interval, 4);
  EXPECT_EQ(output.fields_format, FieldsFormat::Hdf5);
  EXPECT_EQ(output.history_time_interval, 0.5);
  EXPECT_EQ(output.fields_time_interval, 0.25);
  EXPECT_EQ(output.checkpoint.interval, 5);
  EXPECT_EQ(output.checkpoint.clock_interval, 60);
  EXPECT_EQ(output.checkpoint.keep, 7);
  EXPECT_EQ(output.watch.action, WatchAction::Resume);
  EXPECT_EQ(output.watch.tolerance, 1e-6);
  EXPECT_FALSE(output.energies);
  EXPECT_FALSE(output.momenta);
  EXPECT_FALSE(output.interaction);
  EXPECT_TRUE(output.strains);
  EXPECT_EQ(output.interaction_columns, InteractionColumns::Off);
  EXPECT_EQ(output.reactions, (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(output.quantities, (std::vector<std::string>{"work", "mean x [1, 2]"}));
  EXPECT_EQ(output.fields, (std::vector<std::string>{"default", "stress"}));
  EXPECT_EQ(output.norms, (std::vector<std::string>{"stress", "velocity"}));
}

TEST(OutputOptionsTest, SeveralInteractionsHaveColumnsOfTheirOwn) {
  OutputOptions output;
  EXPECT_FALSE(has_interaction_columns(output, 1));
  EXPECT_TRUE(has_interaction_columns(output, 2));
  output.interaction = false;
  EXPECT_FALSE(has_interaction_columns(output, 2));
  output.interaction_columns = InteractionColumns::On;
  EXPECT_TRUE(has_interaction_columns(output, 1));
  output.interaction = true;
  output.interaction_columns = InteractionColumns::Off;
  EXPECT_FALSE(has_interaction_columns(output, 2));
}

TEST(OutputOptionsTest, EitherIntervalGivesFrames) {
  OutputOptions output;
  EXPECT_FALSE(output.has_frames());
  output.fields_interval = 1;
  EXPECT_TRUE(output.has_frames());
  output.fields_interval = 0;
  output.fields_time_interval = 0.1;
  EXPECT_TRUE(output.has_frames());
}

TEST(OutputOptionsTest, OnlyTimeIntervalsThatAreSetCount) {
  OutputOptions output;
  EXPECT_TRUE(output.time_intervals().empty());
  output.fields_time_interval = 0.1;
  EXPECT_EQ(output.time_intervals(), (std::vector<double>{0.1}));
  output.history_time_interval = 0.2;
  EXPECT_EQ(output.time_intervals(), (std::vector<double>{0.2, 0.1}));
}

TEST(OutputOptionsTest, RefusalsNameTheSublist) {
  ParameterList user;
  user.sublist("Checkpoint").set("Keep", -1);
  test::expect_contains(test::refusal([&] { read(user); }), "Checkpoint/Keep: -1 is not allowed");
}

TEST(OutputOptionsTest, FieldsThatDoNotExistAreRefused) {
  ParameterList user;
  user.set("Quantities", Teuchos::Array<std::string>(Teuchos::tuple<std::string>("work", "mean x [1, 2]")));
  user.set("Fields", Teuchos::Array<std::string>(Teuchos::tuple<std::string>("von_misses_stress")));
  const std::string message = test::refusal([&] { read(user); });
  test::expect_contains(
      message, "Output/Fields: field \"von_misses_stress\" does not exist; did you mean \"von_mises_stress\"?");
  test::expect_contains(message, "\"default\", \"displacement\"");
}

}  // namespace
}  // namespace ixos
