#include "logging.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "robotui/rt/testing/fake_setup.h"

namespace robotui::rt::plugins {
namespace {

using testing::FakeRobot;
using testing::FakeSetup;
using testing::PluginBench;

std::vector<std::string> linesOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

class LoggingTest : public ::testing::Test {
 protected:
  ~LoggingTest() override { std::filesystem::remove(file_); }
  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("robotui-logging-test-" + std::to_string(::getpid()) + ".csv");
};

TEST_F(LoggingTest, WritesALineForEachSampleWithoutAllocating) {
  FakeRobot robot(2);
  robot.put("j2", 0.25);
  FakeSetup setup(robot, "{file: " + file_.string() + ", every: 2}");
  Logging logging;
  PluginBench bench(logging, setup);
  ASSERT_TRUE(bench.init()) << setup.failure();
  bench.start();
  bench.cycles(1000);
  bench.stop();
  bench.close();
  const auto lines = linesOf(file_);
  ASSERT_EQ(lines.size(), 501u);
  EXPECT_EQ(lines[0].substr(0, 29), "time,j1.position,j1.velocity,");
  EXPECT_EQ(lines[1], "100.000000,0,0,0,0,0,0.25,0,0,0.25,0");
  EXPECT_EQ(logging.status(), "stopped: 500 samples, 0 lost");
  EXPECT_TRUE(setup.claims().empty());
  EXPECT_EQ(bench.allocations(), 0u);
}

TEST_F(LoggingTest, RefusesAFolderThatIsNotThere) {
  FakeRobot robot(1);
  FakeSetup setup(robot, "{folder: /nowhere/at/all}");
  Logging logging;
  EXPECT_FALSE(PluginBench(logging, setup).init());
  EXPECT_NE(setup.failure().find("/nowhere/at/all"), std::string::npos);
}

}  // namespace
}  // namespace robotui::rt::plugins
