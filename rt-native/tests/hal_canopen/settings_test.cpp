#include "canopen/settings.h"

#include <gtest/gtest.h>

#include "world.h"

namespace robotui::rt::hal::canopen {
namespace {

Settings read(const std::string& params) {
  config::HalConfig config;
  config.params = YAML::Load(params);
  config.place.file = "rt.yaml";
  return readSettings(robotOf(1), config, link::kMillisecond);
}

void expect(const std::string& params, const std::string& part) {
  try {
    read(params);
    FAIL() << params;
  } catch (const config::ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

std::string withDrive(const std::string& drive) { return "{drives: {joint_1: {" + drive + "}}}"; }

TEST(CanOpenSettings, least) {
  const Settings settings = read(withDrive("node: 5, counts_per_radian: 1e4"));
  EXPECT_EQ(settings.interface, "can0");
  EXPECT_EQ(settings.drives.front().node, 5);
  EXPECT_EQ(settings.drives.front().velocity_scale, 1e4);
  EXPECT_EQ(settings.heartbeat_timeout_ns, 300 * link::kMillisecond);
  EXPECT_TRUE(settings.writes_mapping);
}

TEST(CanOpenSettings, objects_are_written_as_data_sheets_have_them) {
  const Settings settings =
      read(withDrive("node: 5, counts_per_radian: 1e4, objects: [[0x6065, 0, u32, 5000], [0x60c2, 2, i8, -3]]"));
  ASSERT_EQ(settings.drives.front().objects.size(), 2U);
  EXPECT_EQ(settings.drives.front().objects[0].object, (Object{0x6065}));
  EXPECT_EQ(settings.drives.front().objects[1].value & 0xffU, 0xfdU);
  EXPECT_EQ(settings.drives.front().objects[1].size, 1);
}

TEST(CanOpenSettings, mistakes_name_the_place_and_what_to_write) {
  expect("{}", "HALInterface.params has no 'drives'; write: drives: {joint_1: {node: 3");
  expect("{drives: {}}", "HALInterface.params.drives has no 'joint_1'; write: joint_1: {node: 3");
  expect("{drives: {joint_1: {node: 1, counts_per_radian: 1e4}, joint_2: {node: 2}}}",
         "rt.yaml:1:64: HALInterface.params.drives.joint_2 is no joint of the joint map, did you mean 'joint_1'?");
  expect(withDrive("node: 128, counts_per_radian: 1"), "drives.joint_1.node is '128'; expected a whole number from 1");
  expect(withDrive("node: 127, counts_per_radian: 1"), "has the node of own_node");
  expect(withDrive("node: 1"), "has no 'counts_per_radian'");
  expect(withDrive("node: 1, counts_per_radian: 0"), "is too near to 0");
  expect(withDrive("node: 1, counts_per_metre: 5"), "is not for this joint, which turns; write counts_per_radian");
  expect(withDrive("node: 1, counts_per_radian: 2e9"), "more than 32 bits at the limits");
  expect(withDrive("node: 1, counts_per_radian: 1, objects: [[0x6065, 0, u9, 1]]"), "expected one of i8, u8");
  expect(withDrive("node: 1, counts_per_radian: 1, objects: [[0x6065, 0, u8, 256]]"), "from 0 to 255");
  expect(withDrive("node: 1, counts_per_radian: 1, objects: [[0x6065, 0]]"), "needs index, sub-index, type and value");
  expect("{modes: [velocity], drives: {joint_1: {node: 1, counts_per_radian: 1}}}", "has no position");
  expect("{modes: [position, effort], drives: {joint_1: {node: 1, counts_per_radian: 1}}}", "rated_torque");
  expect("{mapping: kep, drives: {joint_1: {node: 1, counts_per_radian: 1}}}", "did you mean 'keep'?");
  expect("{interfaces: can1, drives: {}}", "did you mean 'interface'?");
}

}  // namespace
}  // namespace robotui::rt::hal::canopen
