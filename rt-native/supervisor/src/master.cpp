#include "robotui/rt/supervisor/master.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace robotui::rt::supervisor {
namespace {

constexpr double kMostSeconds = 3600;

bool isNumber(const link::JointCommand& command) {
  return std::isfinite(command.position) && std::isfinite(command.velocity) && std::isfinite(command.effort) &&
         std::isfinite(command.stiffness) && std::isfinite(command.damping);
}

}  // namespace

Master::Master(std::uint32_t joints, std::string framework)
    : joints_(joints), framework_(std::move(framework)), segment_(link::Segment<link::MasterSegment>::create(1)),
      writer_(*segment_, joints) {
  segment_.sealAgainstWriters();
  writer_.write(data_);
}

std::string Master::take(std::uint64_t client, std::string_view framework, double seconds, std::int64_t now_ns) {
  if (framework != framework_) {
    const std::string its(framework.substr(0, link::kNameLength));
    return "The master framework of this robot is " + framework_ + ": references of " + its +
           " do not count. MasterCommunicationInterface.framework_name " + "of its configuration chooses it.";
  }
  if (!(seconds > 0) || seconds > kMostSeconds) {
    return "take needs the seconds after which a silent master is no more one, up to 3600.";
  }
  if (holder_ && *holder_ != client) {
    return "Another client commands the robot now.";
  }
  holder_ = client;
  patience_ns_ = static_cast<std::int64_t>(seconds * 1e9);
  until_ns_ = now_ns + patience_ns_;
  return {};
}

std::string Master::release(std::uint64_t client) {
  if (holder_ != client) {
    return "Only who took the robot can release it.";
  }
  end();
  return {};
}

std::string Master::reference(std::uint64_t client, std::string_view bytes, std::int64_t now_ns) {
  if (holder_ != client) {
    return "References came from a client that did not take the robot: they do not count.";
  }
  if (bytes.size() != joints_ * sizeof(link::JointCommand)) {
    return "References of " + std::to_string(bytes.size()) + " bytes came, and " +
           std::to_string(joints_ * sizeof(link::JointCommand)) + " are those of " + std::to_string(joints_) +
           " joints.";
  }
  link::MasterData next{};
  std::memcpy(next.joints.data(), bytes.data(), bytes.size());
  for (std::uint32_t i = 0; i < joints_; ++i) {
    if (next.joints[i].mode != 0 && !isNumber(next.joints[i])) {
      return "The reference of joint " + std::to_string(i) + " is no number: none of these references counts.";
    }
  }
  data_ = next;
  data_.valid_until_ns = now_ns + kValidNs;
  until_ns_ = now_ns + patience_ns_;
  writer_.write(data_);
  return {};
}

void Master::forget(std::uint64_t client) {
  if (holder_ == client) {
    end();
  }
}

bool Master::expire(std::int64_t now_ns) {
  if (!holder_ || now_ns < until_ns_) {
    return false;
  }
  end();
  return true;
}

void Master::end() {
  holder_.reset();
  data_ = {};
  writer_.write(data_);
}

}  // namespace robotui::rt::supervisor
