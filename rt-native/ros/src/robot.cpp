#include "robot.h"

#include "robotui/rt/link/clock.h"

namespace robotui::rt::ros_bridge {
namespace {

constexpr std::chrono::milliseconds kReply{500};
constexpr std::chrono::milliseconds kAnswer{5000};
constexpr std::int64_t kTryEvery = link::kSecond / 2;
constexpr std::int64_t kMasterNs = link::kSecond;  // of silence, then it is no more the master
constexpr const char* kTake = "take 1 ROS";

}  // namespace

Robot::Robot(std::string name, std::size_t joints)
    : name_(std::move(name)), joints_(joints), frame_(std::make_unique<link::FrameData>()) {}

void Robot::keep() {
  if (client_ != nullptr) {
    const link::Notice notice = client_->notice(std::chrono::milliseconds(0));
    if (notice == link::Notice::kNone && reader_) return;
    reader_.reset();
    if (notice == link::Notice::kGone) client_.reset();
  }
  const std::int64_t now = link::now();
  if (now < try_again_ns_) return;
  try {
    attach();
  } catch (const std::runtime_error&) {
    reader_.reset();
    try_again_ns_ = now + kTryEvery;
  }
}

void Robot::attach() {
  if (client_ == nullptr) {
    client_ = std::make_unique<link::Client>(name_, kReply);
    referenced_ns_ = 0;
  }
  attachment_ = client_->attach(kReply);
  reader_.emplace(*attachment_.state);
  if (reader_->counts().joints != joints_) throw link::SegmentError("another robot");
}

bool Robot::sense() { return reader_ && reader_->newest(*frame_) == link::Read::kNew; }

std::string Robot::reference(std::span<const link::JointCommand> commands) {
  if (client_ == nullptr) return "The robot " + name_ + " is not there.";
  const std::int64_t now = link::now();
  if (referenced_ns_ == 0 || now - referenced_ns_ > kMasterNs / 2) {
    const link::Reply reply = client_->request(kTake, kReply);
    if (!reply.ok) return reply.text;
  }
  referenced_ns_ = now;
  return client_->reference(commands) ? std::string() : "The robot " + name_ + " is gone.";
}

link::Reply Requests::ask(const std::string& words) {
  const std::scoped_lock lock(mutex_);
  try {
    if (client_ == nullptr || client_->notice(std::chrono::milliseconds(0)) == link::Notice::kGone) {
      client_ = std::make_unique<link::Client>(name_, kReply);
    }
    return client_->request(words, kAnswer);
  } catch (const std::runtime_error& e) {
    client_.reset();
    return {false, e.what()};
  }
}

}  // namespace robotui::rt::ros_bridge
