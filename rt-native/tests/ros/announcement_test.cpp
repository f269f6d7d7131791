#include "robotui/rt/ros/announcement.h"

#include <gtest/gtest.h>

namespace robotui::rt::ros {
namespace {

Announcement full() {
  Announcement port;
  port.kind = PortKind::kTune;
  port.large = true;
  port.generation = 77;
  port.name = "/some/topic";
  port.type = "std_msgs/Float64";
  port.definition = "float64 data\n";
  port.tunables = {{"gain", "how much", TunableType::kInt, 1, 0, 2}};
  return port;
}

TEST(Announcement, IsReadAsItWasWritten) {
  const Announcement port = readAnnouncement(write(full()));
  EXPECT_EQ(port.kind, PortKind::kTune);
  EXPECT_TRUE(port.large);
  EXPECT_FALSE(port.latched);
  EXPECT_EQ(port.generation, 77u);
  EXPECT_EQ(port.name, "/some/topic");
  EXPECT_EQ(port.definition, "float64 data\n");
  ASSERT_EQ(port.tunables.size(), 1u);
  EXPECT_EQ(port.tunables[0].type, TunableType::kInt);
  EXPECT_EQ(port.tunables[0].most, 2);
}

TEST(Announcement, EveryCutOneIsRefused) {
  const auto bytes = write(full());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(readAnnouncement(std::span(bytes).first(size)), std::runtime_error) << size;
}

TEST(Announcement, LengthsBeyondItAreRefusedBeforeTheyAreAllocated) {
  auto bytes = write(full());
  std::fill(bytes.begin() + 11, bytes.begin() + 19, std::uint8_t{0xff});
  EXPECT_THROW(readAnnouncement(bytes), std::runtime_error);
}

}  // namespace
}  // namespace robotui::rt::ros
