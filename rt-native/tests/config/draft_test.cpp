#include "robotui/rt/config/draft.h"

#include <algorithm>
#include <cmath>

#include "workspace.h"

namespace robotui::rt::config {
namespace {

std::string fileOf(const Draft& draft, const std::string& name) {
  for (const DraftFile& file : draft.files) {
    if (file.name == name) return file.text;
  }
  return {};
}

std::string all(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + "\n";
  return text;
}

void expectIn(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in:\n" << text;
}

std::string refusal(const Workspace& at, const std::string& srdf = {}) {
  try {
    draftOf(at.file("robot.urdf"), srdf.empty() ? std::filesystem::path() : at.file(srdf), at.file("new"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return {};
}

TEST(NewRobot, WhatIsWrittenLoadsAndHasAllThatTheUrdfHas) {
  Workspace at;
  const Draft draft = draftOf(at.file("robot.urdf"), at.file("robot.srdf"), at.file("new"));
  writeDraft(draft, at.file("new"));
  for (const char* name : {"rt-dummy.yaml", "rt-mujoco.yaml"}) {
    const RtConfig config = load(at.file("new") / name, {});
    EXPECT_EQ(all(config.warnings), "");
    ASSERT_EQ(config.robot.joints.size(), 2U);
    EXPECT_EQ(config.robot.joints[0].name, "shoulder");
    EXPECT_DOUBLE_EQ(config.robot.joints[0].velocity, 3);
    EXPECT_DOUBLE_EQ(config.robot.joints[0].acceleration, 30);
    EXPECT_DOUBLE_EQ(config.robot.joints[0].jerk, 600);
    EXPECT_EQ(config.robot.chains.front().name, "arm");
    EXPECT_EQ(config.plugins.front().params["posture"].as<std::string>(), "home");
  }
  EXPECT_EQ(fileOf(draft, "robot.srdf"), "") << "that of the user is enough";
  expectIn(fileOf(draft, "rt-dummy.yaml"), "urdf_path: ../robot.urdf");
  expectIn(all(draft.chosen), "Homing goes to the posture 'home'");
}

TEST(NewRobot, WithoutAnSrdfGroupsEndAtBranchesAndHomeIsWithinTheLimits) {
  Workspace at;
  at.write(
      "robot.urdf",
      R"(<robot name="fork"><link name="base"/><link name="a"/><link name="b"/><link name="left"/><link name="right"/><link name="tool"/>
    <joint name="ja" type="revolute"><parent link="base"/><child link="a"/><limit lower="1" upper="3" velocity="1" effort="9"/></joint>
    <joint name="jb" type="revolute"><parent link="a"/><child link="b"/><limit lower="-1" upper="3" velocity="1" effort="9"/></joint>
    <joint name="jl" type="prismatic"><parent link="b"/><child link="left"/><limit lower="0" upper="0.1" velocity="1" effort="9"/></joint>
    <joint name="jr" type="prismatic"><parent link="b"/><child link="right"/><limit lower="0" upper="0.1" velocity="1" effort="9"/><mimic joint="jl"/></joint>
    <joint name="jt" type="continuous"><parent link="b"/><child link="tool"/></joint></robot>)");
  const Draft draft = draftOf(at.file("robot.urdf"), {}, at.file("new"));
  writeDraft(draft, at.file("new"));
  const RtConfig config = load(at.file("new/rt-dummy.yaml"), {});
  ASSERT_EQ(config.robot.joints.size(), 4U);
  ASSERT_EQ(config.robot.chains.size(), 1U);
  EXPECT_EQ(config.robot.chains.front().tip_link, "b");
  EXPECT_EQ(config.robot.postures.front().joints.front(), (std::pair<std::string, double>{"ja", 2}));
  EXPECT_DOUBLE_EQ(config.robot.joints.back().velocity, 1) << "chosen, as the URDF has none";
  EXPECT_DOUBLE_EQ(config.robot.joints.back().effort, 10);
  expectIn(all(draft.left_out), "'jr', which follows 'jl' (line 5)");
  expectIn(all(draft.left_out), "JointImpedance and GravityCompensation");
  expectIn(all(draft.chosen), "no limit of velocity for jt: chosen is 1 rad/s");
}

TEST(NewRobot, APostureIsAddedToAnSrdfThatHasNone) {
  Workspace at;
  at.write("robot.srdf",
           "<robot name=\"two\"><group name=\"arm\"><chain base_link=\"base\" tip_link=\"hand\"/></group></robot>");
  const Draft draft = draftOf(at.file("robot.urdf"), at.file("robot.srdf"), at.file("new"));
  writeDraft(draft, at.file("new"));
  const RtConfig config = load(at.file("new/rt-dummy.yaml"), {});
  EXPECT_EQ(config.robot.postures.front().name, "home");
  EXPECT_EQ(config.robot.chains.front().name, "arm");
  expectIn(all(draft.chosen), "is a copy with a posture 'home'");
}

TEST(NewRobot, PackagesAreLookedForAboveTheUrdf) {
  Workspace at;
  std::filesystem::create_directories(at.file("src/arm/meshes"));
  at.write("robot.urdf", std::string(kUrdf));
  std::string urdf = kUrdf;
  urdf.replace(
      urdf.find("<link name=\"lower\"/>"), 20,
      "<link name=\"lower\"><visual><geometry><mesh filename=\"package://arm/meshes/a.stl\"/></geometry></visual>"
      "<collision><geometry><mesh filename=\"package://legs/a.stl\"/></geometry></collision></link>");
  at.write("src/arm/robot.urdf", urdf);
  const Draft draft = draftOf(at.file("src/arm/robot.urdf"), {}, at.file("new"));
  expectIn(fileOf(draft, "robot.yaml"), "packages: [" + at.file("src").string() + "]");
  expectIn(all(draft.left_out), "the meshes of the package 'legs'");
}

TEST(NewRobot, NamesThatYamlWouldMisunderstandAreQuoted) {
  Workspace at;
  std::string urdf = kUrdf;
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"\"shoulder\"", "\"no\""}, {"\"elbow\"", "\"a: b #1\""}})
    urdf.replace(urdf.find(from), from.size(), to);
  at.write("robot.urdf", urdf);
  writeDraft(draftOf(at.file("robot.urdf"), {}, at.file("new")), at.file("new"));
  const RtConfig config = load(at.file("new/rt-dummy.yaml"), {});
  EXPECT_EQ(config.robot.joints[0].name, "no");
  EXPECT_EQ(config.robot.joints[1].name, "a: b #1");
}

TEST(NewRobot, RefusesWithFilePlaceAndRemedy) {
  Workspace at;
  expectIn(refusal(at, "none.srdf"), "none.srdf' does not exist; write the path");
  at.write("robot.urdf", "<robot name=\"r\"><link name=\"a\"/></robot>");
  expectIn(refusal(at), "robot.urdf: has no joint that can be commanded: expected one that is revolute");
  at.write("robot.urdf",
           "<robot name=\"r\">\n<link name=\"a\"/>\n<joint name=\"j\" type=\"revolut\"><parent link=\"a\"/><child "
           "link=\"a\"/></joint></robot>");
  expectIn(refusal(at), "robot.urdf:3");
  expectIn(refusal(at), "did you mean 'revolute'?");
}

TEST(NewRobot, WritesOverNothing) {
  Workspace at;
  const Draft draft = draftOf(at.file("robot.urdf"), {}, at.file("new"));
  writeDraft(draft, at.file("new"));
  EXPECT_THROW(writeDraft(draft, at.file("new")), ConfigError);
}

// The block that it writes.
TEST(JointLimits, AreNarrowerThanTheUrdfOrGiveWhatItLacks) {
  Workspace at;
  at.write("rt.yaml", std::string(kConfig) +
                          "JointLimits: {default: {velocity: 3.5, acceleration: 20}, elbow: {jerk: 300, effort: 5}}\n");
  const RtConfig config = load(at.file("rt.yaml"), {});
  EXPECT_DOUBLE_EQ(config.robot.joints[0].velocity, 3) << "the URDF's is narrower";
  EXPECT_DOUBLE_EQ(config.robot.joints[1].velocity, 3.5);
  EXPECT_DOUBLE_EQ(config.robot.joints[1].effort, 5);
  EXPECT_DOUBLE_EQ(config.robot.joints[0].acceleration, 20);
  EXPECT_TRUE(std::isinf(config.robot.joints[0].jerk));
  EXPECT_DOUBLE_EQ(config.robot.joints[1].jerk, 300);
}

TEST(JointLimits, OfTheUrdfAreRead) {
  Workspace at;
  std::string urdf = kUrdf;
  urdf.replace(urdf.find("effort=\"40\""), 11, "effort=\"40\" acceleration=\"12\" jerk=\"90\"");
  at.write("robot.urdf", urdf);
  const RtConfig config = load(at.file("rt.yaml"), {});
  EXPECT_DOUBLE_EQ(config.robot.joints[0].acceleration, 12);
  EXPECT_DOUBLE_EQ(config.robot.joints[0].jerk, 90);
}

TEST(JointLimits, AreRefusedWithPlaceAndRemedy) {
  Workspace at;
  const auto refused = [&](const std::string& block) {
    at.write("rt.yaml", std::string(kConfig) + "JointLimits: " + block + "\n");
    try {
      load(at.file("rt.yaml"), {});
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  expectIn(refused("{elbow: {velocity: 9}}"), "rt.yaml:5");
  expectIn(refused("{elbow: {velocity: 9}}"), "wider than the 4 of the URDF");
  expectIn(refused("{elbwo: {velocity: 1}}"), "did you mean 'elbow'?");
  expectIn(refused("{elbow: {velocity: 0}}"), "JointLimits.elbow.velocity");
  expectIn(refused("{elbow: {speed: 1}}"), "speed");
}

}  // namespace
}  // namespace robotui::rt::config
