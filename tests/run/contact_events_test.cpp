// Times of contact.
#include "run/contact_events.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/snapshot.hpp"

namespace ixos {
namespace {

TEST(ContactEventsSerialTest, TheFirstContactAndTheLastReleaseCount) {
  ContactEvents events({"ball", "wall", "far"});
  const std::vector<std::vector<double>> rows{{0, 2, 0}, {0, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0.5, 0, std::nan("")},
                                              {0, 0, 0}};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    events.row(0.1 * static_cast<double>(k), rows[k]);
    if (k == 4) {
      EXPECT_TRUE(std::isnan(events.times()[0].released)) << "it touches again";
    }
  }
  EXPECT_DOUBLE_EQ(events.times()[0].first, 0.2);
  EXPECT_DOUBLE_EQ(events.times()[0].released, 0.5);
  EXPECT_DOUBLE_EQ(events.times()[1].first, 0);
  EXPECT_DOUBLE_EQ(events.times()[1].released, 0.4);
  EXPECT_TRUE(std::isnan(events.times()[2].first));
  EXPECT_TRUE(std::isnan(events.times()[2].released));
}

TEST(ContactEventsSerialTest, ARestartGoesOn) {
  ContactEvents before({"ball", "wall"}), after({"wall", "ball"});
  before.row(1, {1, 0});
  const ContactEvents* source = &before;
  Snapshot snapshot([&](Record& record) { (source == &before ? before : after).transfer(record); });
  snapshot.save();
  source = &after;
  snapshot.restore();
  after.row(2, {0, 0});
  EXPECT_EQ(after.times()[1].first, 1);
  EXPECT_EQ(after.times()[1].released, 2);
  EXPECT_TRUE(std::isnan(after.times()[0].first));
}

}  // namespace
}  // namespace ixos
