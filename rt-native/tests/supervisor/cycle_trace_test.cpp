#include "cycle_trace.h"

#include <gtest/gtest.h>

#include <sstream>

#include <yaml-cpp/yaml.h>

namespace robotui::rt::supervisor {
namespace {

constexpr std::int64_t kPeriod = 1'000'000;
constexpr std::int64_t kZero = 5'000'000'000;

struct CycleTraceTest : testing::Test {
  CycleTraceTest() { trace.addThread("rt", "rt_main"); }

  // JSON is YAML. The events of one kind and name.
  std::vector<YAML::Node> events(const std::string& kind, const std::string& name) const {
    std::ostringstream out;
    trace.write(out);
    std::vector<YAML::Node> found;
    for (const auto& event : YAML::Load(out.str())["traceEvents"]) {
      if (event["ph"].as<std::string>() == kind && event["name"].as<std::string>() == name) found.push_back(event);
    }
    return found;
  }

  CycleTrace trace{kPeriod};
};

TEST_F(CycleTraceTest, AnAnswerIsAWakeUpAndItsPluginsOneAfterTheOther) {
  trace.addCycle(7, kZero);
  trace.addAnswer(0, 7, kZero + 100'000, {{"Homing", 30'000}, {"Sine", 20'500}});
  const auto homing = events("X", "Homing");
  ASSERT_EQ(homing.size(), 1U);
  EXPECT_EQ(homing[0]["ts"].as<double>(), 49.5);
  EXPECT_EQ(homing[0]["dur"].as<double>(), 30);
  EXPECT_EQ(homing[0]["args"]["cycle"].as<int>(), 7);
  EXPECT_EQ(events("X", "Sine")[0]["ts"].as<double>(), 79.5);
  EXPECT_EQ(events("X", "wake-up")[0]["dur"].as<double>(), 49.5);
  EXPECT_EQ(events("X", "answers")[0]["dur"].as<double>(), 100);
}

TEST_F(CycleTraceTest, CyclesAreLateAgainstTheEarliest) {
  const std::int64_t late[] = {20'000, 0, 350'000, 20'000};
  for (int i = 0; i < 4; ++i) trace.addCycle(1 + static_cast<std::uint64_t>(i), kZero + i * kPeriod + late[i]);
  const auto counted = events("C", "late");
  ASSERT_EQ(counted.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(counted[i]["args"]["us"].as<double>(), static_cast<double>(late[i]) / 1000);
}

TEST_F(CycleTraceTest, WhatFitsNoCycleIsLeftOut) {
  trace.addCycle(1, kZero);
  trace.addAnswer(0, 2, kZero + 10, {});
  trace.addAnswer(1, 1, kZero + 10, {});
  trace.addAnswer(0, 1, kZero - 10, {});
  EXPECT_EQ(trace.answers(), 0U);
  trace.addAnswer(0, 1, kZero + 10'000, {{"Wild", 1'000'000'000}, {"Wilder", -5}});
  EXPECT_EQ(events("X", "Wild")[0]["dur"].as<double>(), 10) << "no longer than the answer took";
  EXPECT_EQ(events("X", "Wilder")[0]["dur"].as<double>(), 0);
}

TEST_F(CycleTraceTest, NamesAreQuotedAndNoCycleIsStillAFile) {
  trace.addThread("a \"host\"", "b\\c");
  const auto names = events("M", "thread_name");
  ASSERT_EQ(names.size(), 3U);
  EXPECT_EQ(names[2]["args"]["name"].as<std::string>(), "b\\c");
  EXPECT_EQ(events("M", "process_name")[2]["args"]["name"].as<std::string>(), "host a \"host\"");
}

}  // namespace
}  // namespace robotui::rt::supervisor
