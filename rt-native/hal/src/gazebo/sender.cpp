#include "sender.h"

#include <algorithm>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/futex.h"

namespace robotui::rt::hal::gazebo {

namespace {

constexpr std::int64_t kWait = 50 * link::kMillisecond;
constexpr std::int64_t kLook = 200 * link::kMillisecond;
constexpr std::int64_t kTimeToListen = 2 * link::kSecond;  // until both sides know each other

}  // namespace

Sender::Sender(const config::RobotDescription& robot, const Settings& settings, Transport& transport,
               std::shared_ptr<JointInbox> states, std::shared_ptr<Notices> notices)
    : states_(std::move(states)), notices_(std::move(notices)) {
  const Topics topics(settings);
  for (const config::JointDescription& joint : robot.joints)
    outputs_.emplace_back(transport, topics, settings.topics, joint);
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void Sender::leave(std::span<const Reference> references, bool is_live) noexcept {
  next_.is_live = is_live ? 1 : 0;
  std::copy_n(references.begin(), std::min(references.size(), outputs_.size()), next_.references.begin());
  commands_.write(next_);
  link::ringBell(bell_);
}

void Sender::stop() noexcept {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  link::ringBell(bell_);
  thread_.join();
}

void Sender::run(const std::stop_token& stop) {
  auto commands = std::make_unique<Commands>();
  std::uint64_t last = 0;
  while (!stop.stop_requested()) {
    const std::uint32_t seen = bell_.load(std::memory_order_acquire);
    if (commands_.read(*commands, last) == link::Read::kNew)
      send(*commands, link::now());
    else
      link::waitForBell(bell_, seen, link::now() + kWait);
    if (link::now() - looked_ns_ > kLook) look(link::now());
  }
}

void Sender::send(const Commands& commands, std::int64_t now_ns) {
  if (commands.is_live == 0) return;
  states_->sample(sample_, last_sample_);
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    JointOutput& output = outputs_[i];
    output.send(commandOf(commands.references[i], sample_.joints[i], output.takesEffort(), output.mostEffort()),
                now_ns);
  }
}

// A joint that nobody moves is told once, and how many others there are.
void Sender::look(std::int64_t now_ns) {
  looked_ns_ = now_ns;
  const JointOutput* first = nullptr;
  std::size_t others = 0;
  for (JointOutput& output : outputs_) {
    output.look();
    if (output.unheard() == nullptr) continue;
    others += first == nullptr ? 0 : 1;
    if (first == nullptr) first = &output;
  }
  if (first == nullptr) {
    unheard_ns_ = 0;
    notices_->clear("unheard", "The simulator listens to the commands of all joints.");
    return;
  }
  if (unheard_ns_ == 0) unheard_ns_ = now_ns;
  if (now_ns - unheard_ns_ < kTimeToListen) return;
  notices_->raise("unheard",
                  "The simulator does not listen to " + *first->unheard() + ", so the joint '" + first->name() +
                      "' does not move" + (others == 0 ? "" : ", and " + std::to_string(others) + " more likewise") +
                      ": give the model a JointPositionController, JointController or ApplyJointForce for it, or " +
                      "write its topic into HALInterface.params.topics.",
                  now_ns);
}

void Sender::hold() {
  states_->sample(sample_, last_sample_);
  for (std::size_t i = 0; i < outputs_.size(); ++i) outputs_[i].hold(sample_.joints[i].position, link::now());
}

}  // namespace robotui::rt::hal::gazebo
