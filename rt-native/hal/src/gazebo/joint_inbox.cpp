#include "joint_inbox.h"

#include <chrono>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::gazebo {

namespace {

constexpr std::size_t kMostNames = 16;

}  // namespace

JointInbox::JointInbox(std::vector<std::string> joints, std::string topic, std::int64_t silence_ns,
                       std::shared_ptr<Notices> notices)
    : joints_(std::move(joints)), topic_(std::move(topic)), notices_(std::move(notices)), gate_(silence_ns) {
  for (std::size_t i = 0; i < joints_.size(); ++i) index_[joints_[i]] = i;
}

void JointInbox::hear(std::string_view type, Bytes message) {
  const std::int64_t now = link::now();
  const std::lock_guard lock(mutex_);
  if (!isType(type, kModel)) return otherType(type);
  const JointsReading reading = readJoints(message, index_, next_);
  if (reading.how != Reading::kSound) return refuse(reading, message);
  unsound_.store(-1, std::memory_order_release);
  notices_->clear("state", "The states of all joints are sound again.");
  went(gate_.admit(next_.stamp_ns, now), now);
}

void JointInbox::went(Stamp stamp, std::int64_t now_ns) {
  if (stamp == Stamp::kLate) drop();
  if (stamp == Stamp::kReset) ++next_.era;
  if (stamp == Stamp::kNew || stamp == Stamp::kReset) take(now_ns);
  if (stamp == Stamp::kReset) {
    notices_->tell("reset",
                   "Simulated time went back: the world was reset, or is another one. The joints are safe where they "
                   "are now; start the plugins again.",
                   now_ns);
  }
}

void JointInbox::take(std::int64_t now_ns) {
  next_.heard_ns = now_ns;
  newest_.write(next_);
  heard_ns_.store(now_ns, std::memory_order_release);
  first_.is_there = true;
  changed_.notify_all();
}

void JointInbox::otherType(std::string_view type) {
  drop();
  first_.other_type = type;
  notices_->tell("type",
                 "On " + topic_ + " come messages of the type " + std::string(type) +
                     ", and no Model with the states of joints: no other program may send there.",
                 link::now());
}

// A state that is refused whole leaves the last one as it was: that grows old, and so the robot becomes safe.
void JointInbox::refuse(JointsReading reading, Bytes message) {
  drop();
  const std::string joint = reading.how == Reading::kUnreadable ? "" : "'" + joints_[reading.joint] + "'";
  std::string sentence = "What comes on " + topic_ + " cannot be read as a Model with a time.";
  if (reading.how == Reading::kNoNumber) {
    unsound_.store(static_cast<int>(reading.joint), std::memory_order_release);
    sentence = "The state of the joint " + joint + " on " + topic_ +
               " is no number: the simulation ran away. Reset the world; shorter steps or more damping help.";
  }
  if (reading.how == Reading::kLacksJoint) {
    first_.missing_joint = joints_[reading.joint];
    first_.names = jointNames(message, kMostNames);
    changed_.notify_all();
    sentence = "The state on " + topic_ + " lacks the joint " + joint +
               ": let the model's JointStatePublisher publish it again.";
  }
  notices_->raise("state", sentence, link::now());
}

FirstState JointInbox::awaitFirst(std::int64_t most_ns) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::nanoseconds(most_ns),
                    [this] { return first_.is_there || !first_.missing_joint.empty(); });
  return first_;
}

}  // namespace robotui::rt::hal::gazebo
