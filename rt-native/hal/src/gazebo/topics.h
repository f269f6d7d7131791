// Names of topics, made from patterns.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "settings.h"

namespace robotui::rt::hal::gazebo {

// Whether the transport takes it as the name of a topic.
bool isTopic(std::string_view name);

// What is wrong with a pattern; empty where nothing is. It may have {world}, {model} and each of `places`, of which it
// needs one where `needs_place`.
std::string patternFault(std::string_view pattern, std::initializer_list<std::string_view> places, bool needs_place);

// The robot's topics.
class Topics {
 public:
  explicit Topics(const Settings& settings) : settings_(&settings) {}

  std::string of(const std::string& pattern) const;
  std::string ofJoint(const std::string& pattern, const std::string& joint) const;
  std::string ofSensor(const std::string& pattern, const config::SensorDescription& sensor) const;

 private:
  const Settings* settings_;
};

}  // namespace robotui::rt::hal::gazebo
