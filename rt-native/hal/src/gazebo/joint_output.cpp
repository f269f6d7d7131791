#include "joint_output.h"

#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::gazebo {

namespace {

constexpr std::int64_t kAgain = 100 * link::kMillisecond;

}  // namespace

JointOutput::JointOutput(Transport& transport, const Topics& topics, const TopicPatterns& patterns,
                         const config::JointDescription& joint)
    : name_(joint.name), most_effort_(joint.effort), topics_{topics.ofJoint(patterns.position, joint.name),
                                                             topics.ofJoint(patterns.velocity, joint.name),
                                                             topics.ofJoint(patterns.effort, joint.name)} {
  for (std::size_t i = 0; i < topics_.size(); ++i) outputs_[i] = transport.advertise(topics_[i]);
}

// Controllers of the simulator go on with the last number for ever: what is left behind is left at rest. One of
// positions knows no rest: it goes on to hold.
void JointOutput::leave(Way way) {
  if (way == Way::kVelocity || way == Way::kEffort) outputs_[index(way)]->publish(0);
}

void JointOutput::send(const Command& command, std::int64_t now_ns) {
  const bool other_way = command.way != last_.way;
  if (other_way) leave(last_.way);
  if (command.way == Way::kNone || (!other_way && command.value == last_.value && now_ns - sent_ns_ < kAgain)) {
    last_.way = command.way;
    return;
  }
  outputs_[index(command.way)]->publish(command.value);
  last_ = command;
  sent_ns_ = now_ns;
}

void JointOutput::hold(double position, std::int64_t now_ns) {
  if (last_.way == Way::kVelocity || last_.way == Way::kEffort) send({Way::kPosition, position}, now_ns);
}

void JointOutput::look() {
  for (std::size_t i = 0; i < outputs_.size(); ++i) listened_[i] = outputs_[i]->hasListeners();
}

const std::string* JointOutput::unheard() const noexcept {
  return last_.way == Way::kNone || listened_[index(last_.way)] ? nullptr : &topics_[index(last_.way)];
}

}  // namespace robotui::rt::hal::gazebo
