// Bytes of another process, sound and hostile.
#include "messages.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <ignition/msgs/imu.pb.h>
#include <ignition/msgs/model.pb.h>
#include <ignition/msgs/world_stats.pb.h>

namespace robotui::rt::hal::gazebo {
namespace {

namespace im = ignition::msgs;

const JointIndex kIndex{{"shoulder", 0}, {"elbow", 1}};

im::Model model(double elbow = 0.5) {
  im::Model model;
  model.mutable_header()->mutable_stamp()->set_sec(3);
  model.mutable_header()->mutable_stamp()->set_nsec(250);
  for (const auto& [name, position] :
       {std::pair{"shoulder", 0.25}, std::pair{"other", 9.0}, std::pair{"elbow", elbow}}) {
    im::Joint& joint = *model.add_joint();
    joint.set_name(name);
    joint.mutable_axis1()->set_position(position);
    joint.mutable_axis1()->set_velocity(2);
    joint.mutable_axis1()->set_force(3);
  }
  return model;
}

template <class Message>
JointsReading read(const Message& message, Sample& into) {
  const std::string bytes = message.SerializeAsString();
  return readJoints(std::as_bytes(std::span(bytes)), kIndex, into);
}

TEST(GazeboMessages, joints_are_found_by_name) {
  Sample sample{};
  EXPECT_EQ(read(model(), sample).how, Reading::kSound);
  EXPECT_EQ(sample.stamp_ns, 3'000'000'250);
  EXPECT_EQ(sample.joints[0].position, 0.25);
  EXPECT_EQ(sample.joints[1].position, 0.5);
  EXPECT_EQ(sample.joints[1].velocity, 2);
  EXPECT_EQ(sample.joints[1].effort, 3);
}

TEST(GazeboMessages, what_lacks_and_what_is_no_number_is_named) {
  Sample sample{};
  const JointsReading infinite = read(model(std::numeric_limits<double>::infinity()), sample);
  EXPECT_EQ(infinite.how, Reading::kNoNumber);
  EXPECT_EQ(infinite.joint, 1U);
  im::Model less = model();
  less.mutable_joint()->RemoveLast();
  const JointsReading lacking = read(less, sample);
  EXPECT_EQ(lacking.how, Reading::kLacksJoint);
  EXPECT_EQ(lacking.joint, 1U);
}

TEST(GazeboMessages, times_that_cannot_be_are_refused) {
  Sample sample{};
  for (const std::int64_t seconds : {std::int64_t{-1}, std::numeric_limits<std::int64_t>::max()}) {
    im::Model wrong = model();
    wrong.mutable_header()->mutable_stamp()->set_sec(seconds);
    EXPECT_EQ(read(wrong, sample).how, Reading::kUnreadable);
  }
  im::Model wrong = model();
  wrong.mutable_header()->mutable_stamp()->set_nsec(-5);
  EXPECT_EQ(read(wrong, sample).how, Reading::kUnreadable);
}

TEST(GazeboMessages, mutated_bytes_and_long_ones_are_borne) {
  const std::string sound = model().SerializeAsString();
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string bytes = sound.substr(0, i % 3 == 0 ? random() % sound.size() : sound.size());
    for (unsigned change = random() % 4; change > 0 && !bytes.empty(); --change)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    Sample sample{};
    const JointsReading reading = readJoints(std::as_bytes(std::span(bytes)), kIndex, sample);
    refused += reading.how == Reading::kSound ? 0 : 1;
    ASSERT_TRUE(reading.how != Reading::kSound || std::isfinite(sample.joints[1].position));
    jointNames(std::as_bytes(std::span(bytes)), 4);
    readImu(std::as_bytes(std::span(bytes)));
    readWrench(std::as_bytes(std::span(bytes)));
    readStatistics(std::as_bytes(std::span(bytes)));
  }
  EXPECT_GT(refused, 5'000);
  Sample sample{};
  const std::string endless((1 << 20) + 1, '\0');
  EXPECT_EQ(readJoints(std::as_bytes(std::span(endless)), kIndex, sample).how, Reading::kUnreadable);
}

TEST(GazeboMessages, an_orientation_is_of_length_one) {
  im::IMU imu;
  imu.mutable_orientation()->set_w(2);
  const std::string bytes = imu.SerializeAsString();
  EXPECT_EQ(readImu(std::as_bytes(std::span(bytes)))->orientation, (std::array<double, 4>{0, 0, 0, 1}));
  EXPECT_EQ(readImu({})->orientation, (std::array<double, 4>{0, 0, 0, 1}));
  imu.mutable_orientation()->set_x(std::numeric_limits<double>::quiet_NaN());
  const std::string wrong = imu.SerializeAsString();
  EXPECT_FALSE(readImu(std::as_bytes(std::span(wrong))));
}

TEST(GazeboMessages, types_have_the_names_of_both_generations) {
  EXPECT_TRUE(isType("ignition.msgs.Model", kModel));
  EXPECT_TRUE(isType("gz.msgs.Model", kModel));
  EXPECT_FALSE(isType("ignition.msgs.Model_V", kModel));
  EXPECT_FALSE(isType("Model", kModel));
}

}  // namespace
}  // namespace robotui::rt::hal::gazebo
