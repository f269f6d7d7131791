#include <gtest/gtest.h>

#include "fake_config.h"

namespace robotui::rt::supervisor {
namespace {

using config::HostKind;

TEST(Plan, GivesEachHostItsThreadsAndEachPluginItsPlace) {
  const auto plan = config::plan(fakeConfig(), {});
  ASSERT_EQ(plan.hosts.size(), 4u);
  EXPECT_EQ(plan.hosts[0].name, "rt");
  EXPECT_EQ(plan.hosts[0].threads.size(), 2u);
  EXPECT_EQ(plan.hosts[1].name, "other");
  EXPECT_EQ(plan.hosts[2].name, "nrt");
  EXPECT_EQ(plan.hosts[2].kind, HostKind::kOrdinary);
  EXPECT_EQ(plan.hosts[2].threads[0].scheduling, config::Scheduling::kOther);
  EXPECT_EQ(plan.hosts[3].kind, HostKind::kIo);
  EXPECT_EQ(plan.hosts[3].threads[0].period, std::chrono::microseconds(5000));
  ASSERT_EQ(plan.plugins.size(), 7u);
  EXPECT_EQ(plan.plugins[1].thread, 1u);
  EXPECT_EQ(plan.plugins[2].host, 1u);
}

TEST(Plan, HasNoIoPluginsWithoutCommunicationHandler) {
  const auto plan = config::plan(fakeConfig(), {.enabled = false});
  EXPECT_EQ(plan.hosts.size(), 3u);
  EXPECT_EQ(plan.plugins.size(), 6u);
}

TEST(Plan, RefusesAHostThatIsCalledLikeOneOfOurs) {
  auto config = fakeConfig();
  config.threads[2].host = "nrt";
  EXPECT_THROW(config::plan(config, {}), config::ConfigError);
}

TEST(Plan, RefusesMoreThanTheLinkHasRoomFor) {
  auto config = fakeConfig();
  for (int i = 0; i < 70; ++i) {
    config.plugins.push_back(pluginOf("p" + std::to_string(i), "Sine", "fast"));
  }
  try {
    config::plan(config, {});
    FAIL();
  } catch (const config::ConfigError& e) {
    EXPECT_NE(std::string(e.what()).find("there are 77 plugins, and room for 64"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace robotui::rt::supervisor
