#include "workspace.h"

namespace robotui::rt::config {
namespace {

using testing::Test;

struct Mistakes : Test {
  Workspace at;
  void expect(const std::string& more, const std::string& said) const {
    const std::string text = at.mistake(more);
    EXPECT_NE(text.find(said), std::string::npos) << "said: " << text;
  }
  void urdf(const std::string& what, const std::string& by) const { at.write("robot.urdf", replaced(kUrdf, what, by)); }
  void srdf(const std::string& what, const std::string& by) const { at.write("robot.srdf", replaced(kSrdf, what, by)); }
  void map(const std::string& text) const { at.write("map.yaml", text); }
};

TEST_F(Mistakes, MissingFiles) {
  EXPECT_THROW(load(at.file("none.yaml"), {}), ConfigError);
  std::filesystem::remove(at.file("robot.urdf"));
  expect("", "rt.yaml:2:14: the URDF 'robot.urdf' does not exist; write the path");
  std::filesystem::create_directory(at.file("robot.urdf"));
  expect("", "is not a file");
}

TEST_F(Mistakes, FilesTooLargeToBeMeant) {
  std::filesystem::resize_file(at.file("robot.urdf"), (std::uintmax_t{16} << 20) + 1);
  expect("", "rt.yaml:2:14: the URDF 'robot.urdf' has 16777217 bytes; at most 16777216 are read");
}

TEST_F(Mistakes, WrongYaml) {
  expect("HALInterface: {type: dummy\n", "rt.yaml:6:1: is not YAML: ");
  expect("a: " + std::string(20000, '[') + "\n", "rt.yaml:5: brackets are nested more than 100 deep");
  expect("RobotName: a\nRobotName: b\n", "rt.yaml:6:1: has the key 'RobotName' twice");
  at.write("rt.yaml", "- a list\n");
  EXPECT_THROW(load(at.file("rt.yaml"), {}), ConfigError);
}

TEST_F(Mistakes, SlipsOfThePenAreNamed) {
  expect("XBotRTPlugin: {plugins: [A]}\n", "rt.yaml:5:15: XBotRTPlugin is not a key, did you mean 'XBotRTPlugins'?");
  expect("HALInterface: {deadlin: 0.5}\n", "did you mean 'deadline'?");
  expect("HALInterface: {type: mujoko}\n",
         "rt.yaml:5:22: HALInterface.type is 'mujoko'; expected one of dummy, mujoco, gazebo, udp, canopen, ethercat, "
         "library, did you mean 'mujoco'?");
}

TEST_F(Mistakes, LimitsOfJointsThatAreNot) {
  expect("HALInterface: {following_error: {elbo: 0.1}}\n", "did you mean 'elbow'?");
  expect("HALInterface: {following_error: -1}\n", "HALInterface.following_error");
  expect("HALInterface: {following_error: {elbow: a lot}}\n", "HALInterface.following_error.elbow");
}

TEST_F(Mistakes, EmergencyStopsThatAreNone) {
  const auto stops = [](const std::string& type, const std::string& text) {
    return "HALInterface: {type: " + type + ", emergency_stops: {" + text + "}}\n";
  };
  expect(stops("canopen", "door: {input: 16}"), "needs the joint whose drive has the input");
  expect(stops("canopen", "door: {joint: elbo, input: 16}"), "did you mean 'elbow'?");
  expect(stops("canopen", "door: {joint: elbow}"), "input: 16");
  expect(stops("canopen", "door: {joint: elbow, input: 32}"), "HALInterface.emergency_stops.door.input");
  expect(stops("dummy", "a: {input: 1}, b: {}"), "has the input of a");
  expect(stops("dummy", "a: {bit: 1}"), "HALInterface.emergency_stops.a.bit");
  expect(stops("dummy", "'': {}"), "needs a name of 1 to 63 characters");
}

TEST_F(Mistakes, SwitchGroupsThatAreNone) {
  const auto groups = [](const std::string& text) {
    return "XBotRTPlugins: {plugins: [Homing, Sine], io_plugins: [Talk]}\nswitch_groups: {" + text + "}\n";
  };
  expect(groups("walk: {start: [Hominh]}"), "did you mean 'Homing'?");
  expect(groups("walk: {start: [Talk]}"), "is the IO plugin 'Talk'");
  expect(groups("walk: {start: [Sine], stop: [Sine]}"), "has the plugin 'Sine' twice");
  expect(groups("walk: {}"), "switch_groups.walk names no plugin; write {start:");
  expect(groups("walk: {begin: [Sine]}"), "switch_groups.walk.begin");
  expect(groups("'a b': {start: [Sine]}"), "expected at most 63 letters");
}

TEST_F(Mistakes, DeadlinesThatTheKernelWouldRefuse) {
  expect("HALInterface: {sched: deadline, core_id: 0}\n", "core_id cannot be with sched: deadline");
  expect("HALInterface: {sched: deadline, prio: 80}\n", "prio means nothing with sched: deadline");
  expect("HALInterface: {sched: deadline, runtime: 1}\n", "HALInterface.runtime");
  expect("xbotcore_threads: {rt_main: {sched: deadline}}\n",
         "the thread 'rt_main' has sched: deadline, which goes before the HAL's priority");
}

TEST_F(Mistakes, MissingKeys) {
  at.write("rt.yaml", "RobotName: x\n");
  try {
    load(at.file("rt.yaml"), {});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("'XBotInterface' is missing; write: XBotInterface: {urdf_path:"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(Mistakes, ValuesOutOfRange) {
  expect("HALInterface: {deadline: 2}\n",
         "rt.yaml:5:26: HALInterface.deadline is '2'; expected a number from 0.05 to 0.95");
  expect("HALInterface: {deadline: .nan}\n", "expected a number");
  expect("HALInterface: {misses_before_safe: 0}\n", "expected a whole number from 1 to 1000");
  expect("HALInterface: {type: library}\n", "no 'lib_file'");
  expect("xbotcore_threads: {a: {period: 1000}}\n", "is in seconds; write 0.001");
  expect("xbotcore_threads: {a: {period: 0.0015}}\n", "is no multiple of the HAL's, 1000 us");
}

TEST_F(Mistakes, ThreadsThatCannotBe) {
  expect("xbotcore_threads: {a: {core_id: 1000}}\n",
         "rt.yaml:5:33: xbotcore_threads.a.core_id is 1000, on which this process may not run; there are ");
  expect("xbotcore_threads: {a: {prio: 90}}\n",
         "rt.yaml:5:23: the thread 'a' has the priority 90; it must be below the HAL's, 90");
  expect("xbotcore_threads: {fast: {}}\nxbotcore_plugins: {p: {thread: fats}}\n",
         "rt.yaml:6:23: the plugin 'p' is to run in the thread 'fats', which is not in xbotcore_threads; there are "
         "fast, did you mean 'fast'?");
  std::string many = "xbotcore_threads:\n";
  for (int i = 0; i < 9; ++i) many += "  t" + std::to_string(i) + ": {}\n";
  expect(many, "the host 'rt' has more than 8 threads");
}

TEST_F(Mistakes, PluginsTwiceOrWithNamesThatAreNone) {
  expect("XBotRTPlugins: {plugins: [A, A]}\n", "the plugin 'A' is there already in line 5");
  expect("XBotRTPlugins: {plugins: [../evil]}\n", "expected at most 63 letters");
}

TEST_F(Mistakes, JointMap) {
  map("joint_map:\n  1: sholder\n");
  expect("",
         "map.yaml:2:6: joint_map.1 is 'sholder', but the URDF has no joint of that name, did you mean 'shoulder'?");
  map("joint_map: {1: shoulder, 2: shoulder}\n");
  expect("", "map.yaml:1:29: joint_map.2 is 'shoulder', which has the id 1 already");
  map("joint_map: {1: shoulder, 01: elbow}\n");
  expect("", "has the id 1, which 'shoulder' has already");
  map("joint_map: {1: shoulder, 1: elbow}\n");
  expect("", "has the key '1' twice");
  map("joint_map: {1: wrist_mount}\n");
  expect("",
         "is 'wrist_mount', which is fixed in the URDF (robot.urdf:11): it cannot be moved; take it out of the map");
  map("joint_map: {one: shoulder}\n");
  expect("", "no whole number");
  map("joints: {1: shoulder}\n");
  expect("", "map.yaml:1:1: the key 'joint_map' is missing; write: joint_map: {1: ");
  map("joint_map: {}\n");
  expect("", "joint_map is empty");
}

TEST_F(Mistakes, JointsWithoutLimits) {
  urdf(R"(<limit lower="-1" upper="2" velocity="3" effort="40"/>)", "");
  expect("", "robot.urdf:7: the joint 'shoulder' is in the joint map but has no limits");
  urdf(R"(lower="-1" upper="2")", R"(lower="2" upper="2")");
  expect("", "its lower limit must be below its upper one");
  urdf(R"(upper="2")", R"(upper="nan")");
  expect("", R"(robot.urdf:8: <limit> has upper="nan"; expected a number)");
  urdf(R"(type="revolute")", R"(type="floating")");
  expect("", "which is floating in the URDF");
}

TEST_F(Mistakes, UrdfsThatAreNoTree) {
  urdf(R"(<child link="lower"/>)", R"(<child link="upper"/>)");
  expect("", "is the second joint above the link 'upper'");
  urdf(R"(<parent link="base"/>)", R"(<parent link="hand"/>)");
  expect("", "carries itself; links must be a tree");
  urdf(R"(<parent link="base"/>)", R"(<parent link="bose"/>)");
  expect("", "joins the link 'bose', which is not there, did you mean 'base'?");
  urdf(R"(<link name="hand"/>)", R"(<link name="hand"/><link name="lost"/>)");
  expect("", "several links that nothing carries");
  urdf(R"(type="continuous")", R"(type="continuos")");
  expect("", "has the unknown type 'continuos', did you mean 'continuous'?");
  urdf(R"(<link name="hand"/>)", R"(<link name="hand"/><link name="hand"/>)");
  expect("", "is there twice");
}

TEST_F(Mistakes, XmlThatIsNotRead) {
  urdf("<robot name", "<!DOCTYPE r [<!ENTITY a \"aaaa\">]>\n<robot name");
  expect("", "robot.urdf:2: has a document type or entities of its own, which are not read; remove them");
  urdf("</robot>", "");
  expect("", "robot.urdf:2: is not XML: ");
  at.write("robot.urdf", "");
  expect("", "is not XML");
  at.write("robot.urdf", "<sdf/>");
  expect("", "expected <robot name");
  std::string deep = "<robot name=\"d\">";
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  at.write("robot.urdf", deep);
  expect("", "is not XML: XML_ELEMENT_DEPTH_EXCEEDED");
}

TEST_F(Mistakes, MassesThatAreNone) {
  urdf(R"(<mass value="1"/>)", R"(<mass value="-1"/>)");
  expect("", "robot.urdf:4: <link> 'upper' has a negative mass");
  urdf(R"(ixx="0.1")", R"(ixx="-0.1")");
  expect("", "robot.urdf:4: <link> 'upper' has a negative ixx, which no body has; mend it, or go on with ");
  urdf(R"(ixx="0.1")", R"(ixx="heavy")");
  expect("", R"(<inertia> has ixx="heavy"; expected a number)");
}

TEST_F(Mistakes, Srdf) {
  srdf(R"(<group name="arm"/>)", R"(<group name="amr"/>)");
  expect("", "there is no group of that name, did you mean 'arm'?");
  srdf(R"(value="0.5")", R"(value="half")");
  expect("", "expected a number");
}

}  // namespace
}  // namespace robotui::rt::config
