#include <algorithm>
#include <limits>

#include "robotui/rt/config/reader.h"
#include "robotui/rt/link/deadline.h"
#include "workspace.h"

namespace robotui::rt::config {
namespace {

using std::chrono::microseconds;

bool anyContains(const std::vector<std::string>& lines, const std::string& what) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const auto& line) { return line.find(what) != std::string::npos; });
}

TEST(Load, TheLeastConfigurationHasSafeDefaults) {
  const auto config = Workspace{}.load();
  EXPECT_EQ(config.robot.name, "two");
  EXPECT_EQ(config.hal.type, "dummy");
  EXPECT_EQ(config.hal.period, microseconds(1000));
  EXPECT_EQ(config.hal.misses_before_safe, 2);
  EXPECT_EQ(config.hal.wake_latency_us, 0);
  EXPECT_EQ(config.hal.safe_law, SafeLaw::kGravity);
  EXPECT_TRUE(config.hal.params.IsMap());
  EXPECT_EQ(config.model_type, "KDL");
  EXPECT_EQ(config.master, "robotui");
  ASSERT_EQ(config.threads.size(), 1U);
  EXPECT_EQ(config.threads[0].name, "rt_main");
  EXPECT_TRUE(config.warnings.empty());
}

TEST(Load, JointsAreSupervisedUnlessThatIsTurnedOff) {
  const double none = std::numeric_limits<double>::infinity();
  const auto limits = [](const std::string& more) { return Workspace{}.load(more).hal.following_errors; };
  EXPECT_EQ(limits(""), (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(limits("HALInterface: {following_error: 0.2}\n"), (std::vector<double>{0.2, 0.2}));
  EXPECT_EQ(limits("HALInterface: {following_error: 0}\n"), (std::vector<double>{none, none}));
  EXPECT_EQ(limits("HALInterface: {following_error: {elbow: 0.1}}\n"), (std::vector<double>{0.5, 0.1}));
  EXPECT_EQ(limits("HALInterface: {following_error: {elbow: 0, default: 0.3}}\n"), (std::vector<double>{0.3, none}));
  EXPECT_EQ(Workspace{}.load("HALInterface: {following_time: 0.05}\n").hal.following_time, 0.05);
}

TEST(Load, EmergencyStopsHaveNamesAndInputs) {
  EXPECT_TRUE(Workspace{}.load().hal.emergency_stops.empty());
  const auto stops =
      Workspace{}.load("HALInterface: {emergency_stops: {cell door: {}, mat: {closed: false}}}\n").hal.emergency_stops;
  ASSERT_EQ(stops.size(), 2U);
  EXPECT_EQ(stops[0].name, "cell door");
  EXPECT_TRUE(stops[0].closed);
  EXPECT_EQ(stops[1].input, 1);
  EXPECT_FALSE(stops[1].closed);
  const auto on_bus =
      Workspace{}
          .load("HALInterface: {type: canopen, emergency_stops: {pendant: {joint: elbow, input: 16}}}\n")
          .hal.emergency_stops;
  EXPECT_EQ(on_bus.at(0).joint, "elbow");
  EXPECT_EQ(on_bus.at(0).input, 16);
}

TEST(Load, GroupsOfPluginsAreNamed) {
  const auto groups = Workspace{}
                          .load(
                              "XBotRTPlugins: {plugins: [Walk, Stand]}\nNRTPlugins: {plugins: [Look]}\n"
                              "switch_groups: {walk: {start: [Walk, Look], stop: [Stand]}, rest: {stop: [Walk]}}\n")
                          .switch_groups;
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].start, (std::vector<std::string>{"Walk", "Look"}));
  EXPECT_EQ(groups[0].stop, std::vector<std::string>{"Stand"});
  EXPECT_TRUE(groups[1].start.empty());
}

TEST(Load, ANegativeInertiaIsKeptAndWarnedOfWhereThatIsWanted) {
  const Workspace at;
  at.write("robot.urdf", replaced(kUrdf, R"(ixx="0.1")", R"(ixx="-0.1")"));
  const auto config = at.load("ModelInterface: {negative_inertia: keep}\n");
  ASSERT_EQ(config.warnings.size(), 1U);
  EXPECT_TRUE(anyContains(config.warnings, "robot.urdf:4: <link> 'upper' has a negative ixx, which is kept"));
  EXPECT_THROW(at.load("ModelInterface: {negative_inertia: maybe}\n"), ConfigError);
}

// As they are published: with elements of MoveIt, and with groups of variants that this robot is not.
TEST(Load, AnSrdfMayNameWhatTheUrdfLacks) {
  const Workspace at;
  at.write("robot.srdf", R"(<?xml version="1.0"?>
<robot name="two">
  <virtual_joint name="world_joint" type="floating" parent_frame="world" child_link="base"/>
  <passive_joint name="caster"/>
  <passive_joint name="elbow"/>
  <group name="imu_sensors"><link name="base"/><link name="head"/></group>
  <group name="force_torque_sensors"><joint name="wrist_mount"/><joint name="ankle"/></group>
  <group name="arm"><chain base_link="base" tip_link="hand"/></group>
  <group name="other_arm"><chain base_link="base" tip_link="other_hand"/></group>
  <group name="backwards"><chain base_link="hand" tip_link="base"/></group>
  <group name="moveit"><joint name="world_joint"/><joint name="shoulder"/><joint name="finger"/><link name="nail"/></group>
  <end_effector name="gripper" parent_link="palm" group="none"/>
  <disable_collisions link1="base" link2="nowhere" reason="Never"/>
  <group_state group="arm" name="home"><joint name="shoulder" value="0.5"/><joint name="finger" value="1"/></group_state>
</robot>
)");
  const auto config = at.load();
  ASSERT_EQ(config.robot.chains.size(), 2U);
  EXPECT_EQ(config.robot.chains[0].name, "arm");
  EXPECT_EQ(config.robot.chains[1].joints, std::vector<std::string>{"shoulder"});
  EXPECT_EQ(config.robot.imus.size(), 1U);
  EXPECT_EQ(config.robot.force_torques.size(), 1U);
  EXPECT_EQ(config.robot.postures.at(0).joints.size(), 1U);
  for (const char* said :
       {"'head'", "'ankle' is not in the URDF: it is left out", "'other_hand'", "'finger'", "'nail'",
        "'backwards' goes from 'hand' to 'base', but the first does not carry the second: it is left out",
        "robot.srdf:5: 'elbow' is a passive_joint, and all the same in the joint map: it is commanded"}) {
    EXPECT_TRUE(anyContains(config.warnings, said)) << said;
  }
  EXPECT_FALSE(anyContains(config.warnings, "world_joint"));
}

TEST(Load, TheMasterFrameworkIsThatOfXBotOrOurs) {
  EXPECT_TRUE(Workspace{}.load().enable_ref_read);
  EXPECT_EQ(Workspace{}.load("MasterCommunicationInterface: {framework_name: ROS}\n").master, "ROS");
  const auto config = Workspace{}.load("MasterCommunicationInterface: {framework_name: ros, enable_ref_read: false}\n");
  EXPECT_EQ(config.master, "ROS");
  EXPECT_FALSE(config.enable_ref_read);
  EXPECT_THROW(Workspace{}.load("MasterCommunicationInterface: {framework_name: OROCOS}\n"), ConfigError);
}

TEST(Load, ThePlainListIsOneThreadInSequence) {
  const auto config = Workspace{}.load(
      "XBotRTPlugins: {plugins: [Homing, {name: S, type: Sine, params: {f: 2}}], io_plugins: [Io]}\n"
      "NRTPlugins: {plugins: [Slow]}\n");
  ASSERT_EQ(config.plugins.size(), 2U);
  EXPECT_EQ(config.plugins[0].type, "Homing");
  EXPECT_EQ(config.plugins[1].name, "S");
  EXPECT_EQ(config.plugins[1].thread, config.plugins[0].thread);
  EXPECT_EQ(config.plugins[1].params["f"].as<int>(), 2);
  EXPECT_EQ(config.io_plugins.at(0).name, "Io");
  EXPECT_TRUE(config.io_plugins[0].thread.empty());
  EXPECT_EQ(config.nrt_plugins.at(0).name, "Slow");
}

TEST(Load, NewerThreadsAndPluginsAreRead) {
  const auto config = Workspace{}.load(R"(
xbotcore_threads:
  fast: {sched: fifo, prio: 70, period: 0.001, core_id: 0}
  slow: {sched: other, period: 0.01, host: calm}
xbotcore_plugins:
  homing: {thread: slow, type: Homing}
)");
  ASSERT_EQ(config.threads.size(), 2U);
  EXPECT_EQ(config.threads[0].priority, 70);
  EXPECT_EQ(config.threads[0].core, 0);
  EXPECT_EQ(config.threads[1].scheduling, Scheduling::kOther);
  EXPECT_EQ(config.threads[1].priority, 0);
  EXPECT_EQ(config.threads[1].period, microseconds(10000));
  EXPECT_EQ(config.threads[1].host, "calm");
  EXPECT_EQ(config.plugins.at(0).thread, "slow");
}

TEST(Load, DeadlinesStandWherePrioritiesDo) {
  const auto config = Workspace{}.load(R"(
HALInterface: {sched: deadline, runtime: 0.2}
xbotcore_threads:
  fast: {sched: deadline, period: 0.001}
  slow: {prio: 70, period: 0.01}
)");
  EXPECT_EQ(config.hal.priority, link::kByDeadline);
  EXPECT_EQ(config.hal.runtime, 0.2);
  EXPECT_EQ(config.threads.at(0).scheduling, Scheduling::kDeadline);
  EXPECT_EQ(config.threads[0].priority, link::kByDeadline);
  EXPECT_EQ(config.threads[0].runtime, 0.3);
  EXPECT_EQ(config.threads.at(1).priority, 70);
}

TEST(Load, TheHalHasKeysOfOurs) {
  const auto hal = Workspace{}
                       .load(
                           "HALInterface: {type: mujoco, deadline: 0.5, misses_before_safe: 4, safe_law: damping, "
                           "safe_damping: 2.5, "
                           "period_us: 500, prio: 80, core_id: 0, cpu_dma_latency_us: -1, params: {steps: 2}}\n")
                       .hal;
  EXPECT_EQ(hal.type, "mujoco");
  EXPECT_EQ(hal.deadline, 0.5);
  EXPECT_EQ(hal.misses_before_safe, 4);
  EXPECT_EQ(hal.safe_law, SafeLaw::kDamping);
  EXPECT_EQ(hal.safe_damping, 2.5);
  EXPECT_EQ(hal.period, microseconds(500));
  EXPECT_EQ(hal.priority, 80);
  EXPECT_EQ(hal.wake_latency_us, -1);
  EXPECT_EQ(hal.core, 0);
  EXPECT_EQ(hal.params["steps"].as<int>(), 2);
}

TEST(Load, ALibraryIsAHalRelativeToTheFile) {
  const Workspace at;
  const auto hal = at.load("HALInterface: {lib_file: lib/libMine.so, lib_name: Mine}\n").hal;
  EXPECT_EQ(hal.type, "library");
  EXPECT_EQ(hal.lib_file, at.file("lib/libMine.so"));
  EXPECT_EQ(at.load("HALInterface: {lib_file: libMine.so}\n").hal.lib_file, "libMine.so");
}

TEST(Load, OverridesChooseTheDummyAndMoveThePeriodOfThoseThatFollow) {
  const auto config = Workspace{}.load(
      "HALInterface: {type: udp, params: {port: 4}}\n"
      "xbotcore_threads: {a: {period: 0.001}, b: {period: 0.004}}\n",
      {true, microseconds(2000)});
  EXPECT_EQ(config.hal.type, "dummy");
  EXPECT_EQ(config.hal.params.size(), 0U);
  EXPECT_EQ(config.hal.period, microseconds(2000));
  EXPECT_EQ(config.threads[0].period, microseconds(2000));
  EXPECT_EQ(config.threads[1].period, microseconds(4000));
}

TEST(Load, OlderNamesAreTakenWithAWarning) {
  const Workspace at;
  at.write(
      "rt.yaml",
      "x_bot_interface: {urdf_path: robot.urdf, joint_map_config: map.yaml}\nModelInterface: {model_type: RBDL}\n");
  const auto config = load(at.file("rt.yaml"), {});
  EXPECT_EQ(config.robot.joints.size(), 2U);
  EXPECT_TRUE(anyContains(config.warnings, "write 'XBotInterface'"));
  EXPECT_TRUE(anyContains(config.warnings, "write 'joint_map_path'"));
  EXPECT_TRUE(anyContains(config.warnings, "RBDL"));
}

TEST(Load, BlocksThatNobodyKnowsAreWarnedOf) {
  const auto config = Workspace{}.load("GazeboXBotPlugin: {x: 1}\nSimulationOptions: {verbose_mode: true}\n");
  EXPECT_EQ(config.warnings.size(), 2U);
  EXPECT_TRUE(anyContains(config.warnings, "rt.yaml:5:"));
}

TEST(Load, ParametersAreReadWithPlaces) {
  const auto config = Workspace{}.load("HALInterface:\n  params:\n    steps: many\n");
  const Reader params(config.hal.params, config.file, "params", config.hal.place);
  try {
    params.wholeOr("steps", 1, 1, 10);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(
        std::string(error.what()).find("rt.yaml:7:12: params.steps is 'many'; expected a whole number from 1 to 10"),
        std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace robotui::rt::config
