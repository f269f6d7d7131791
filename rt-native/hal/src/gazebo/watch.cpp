#include "watch.h"

#include <algorithm>

#include "robotui/rt/link/words.h"

namespace robotui::rt::hal::gazebo {

namespace {

constexpr std::int64_t kTimeToSense = 5 * link::kSecond;
constexpr std::size_t kMostTopics = 8;

// Models that are there, as their topics say.
std::vector<std::string> stateTopics(const Transport& transport) {
  std::vector<std::string> found;
  for (const std::string& topic : transport.topics()) {
    if (topic.ends_with("/joint_state") && found.size() < kMostTopics) found.push_back(topic);
  }
  return found;
}

std::string nobody(const std::string& topic, const Transport& transport) {
  const auto others = stateTopics(transport);
  if (!others.empty()) {
    return "Nobody sends " + topic + "; there is " + link::listed(others) +
           ": write the world and the model into HALInterface.params.";
  }
  if (!transport.topics().empty()) {
    return "Gazebo is there, but nobody sends " + topic +
           ": give the model a JointStatePublisher, or write world and model into HALInterface.params.";
  }
  return "No Gazebo was found in the partition '" + transport.partition() + "' at " + Transport::address() +
         ": start it, or write its partition and the address of the network interface into HALInterface.params.";
}

}  // namespace

std::string whyNoState(const FirstState& first, const Settings& settings, const std::string& topic,
                       const std::string& joint, const Transport& transport) {
  if (!first.missing_joint.empty()) {
    return "The model '" + settings.model + "' in Gazebo has no joint '" + first.missing_joint + "'; its state on " +
           topic + " has: " + link::listed(first.names, {}, "none") +
           ". Give joints the same names in the joint map and in the model, and let its JointStatePublisher publish "
           "them all.";
  }
  if (!first.other_type.empty()) {
    return "On " + topic + " come messages of the type " + first.other_type +
           ", and no Model with the states of joints: write another topic into "
           "HALInterface.params.topics.joint_state.";
  }
  if (transport.sourcesOf(topic).empty()) return nobody(topic, transport);
  return "Somebody offers " + topic + ", but no state of the joint '" + joint +
         "' came that can be read: look whether the world was loaded, and runs.";
}

Watch::Watch(const Transport& transport, const Settings& settings, std::string first_joint,
             std::shared_ptr<const JointInbox> joints, std::shared_ptr<const WorldInbox> world,
             std::shared_ptr<Notices> notices)
    : transport_(&transport), settings_(&settings), first_joint_(std::move(first_joint)), joints_(std::move(joints)),
      world_(std::move(world)), notices_(std::move(notices)), begun_ns_(link::now()) {}

void Watch::silent(std::int64_t now_ns) {
  notices_->raise("silence",
                  "The joint '" + first_joint_ + "' and all others of the model '" + settings_->model +
                      "' are silent: no newer state comes on " + joints_->topic() +
                      ". Look whether the simulator runs; where it is slow, give HALInterface.params a longer "
                      "timeout_us. The joints are safe until plugins are started anew.",
                  now_ns);
  // The transport needs some seconds until it misses a program that was killed.
  if (transport_->sourcesOf(joints_->topic()).empty())
    notices_->raise("gone", "Nobody offers " + joints_->topic() + " any more: start the simulator again.", now_ns);
}

// A pause has its own sentence.
void Watch::look() {
  const std::int64_t now = link::now();
  if (now - joints_->heardNs() > settings_->timeout_ns) {
    if (world_->pausedNs() == 0) silent(now);
    return;
  }
  notices_->clear("silence", "The simulator sends again: joints hold where they are now.");
  notices_->clear("gone", "");
}

void Watch::missesSensor(const std::string& name, const std::string& topic) {
  const std::int64_t now = link::now();
  if (now - begun_ns_ < kTimeToSense || world_->pausedNs() != 0) return;
  notices_->raise("no sensor " + name,
                  "Nothing comes from the sensor '" + name + "' on " + topic +
                      ": give the world the system of this sensor, and write the topic into "
                      "HALInterface.params.topics.",
                  now);
}

}  // namespace robotui::rt::hal::gazebo
