#include "topics.h"

#include <algorithm>
#include <vector>

namespace robotui::rt::hal::gazebo {

namespace {

constexpr std::size_t kLongest = 1024;

std::string filled(std::string text, const std::string& place, const std::string& value) {
  const std::string mark = "{" + place + "}";
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size()))
    text.replace(at, mark.size(), value);
  return text;
}

}  // namespace

bool isTopic(std::string_view name) {
  const bool has_strange = std::any_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) <= ' ' || c == '@' || c == '~' || c == '{' || c == '}';
  });
  return name.size() > 1 && name.size() < kLongest && name.front() == '/' && !has_strange &&
         name.find("//") == std::string_view::npos && name.find(":=") == std::string_view::npos;
}

std::string patternFault(std::string_view pattern, std::initializer_list<std::string_view> places, bool needs_place) {
  std::string text = filled(filled(std::string(pattern), "world", "w"), "model", "m");
  std::string missing;
  bool has_place = !needs_place;
  for (const std::string_view place : places) {
    missing += (missing.empty() ? "{" : " or {") + std::string(place) + "}";
    const std::string with = filled(text, std::string(place), "x");
    has_place = has_place || with != text;
    text = with;
  }
  if (!has_place) return "lacks " + missing + ", by which it is another topic for each";
  if (isTopic(text)) return {};
  return "is no topic: expected something such as /model/{model}/" +
         std::string(places.size() == 0 ? "state" : missing);
}

std::string Topics::of(const std::string& pattern) const {
  return filled(filled(pattern, "world", settings_->world), "model", settings_->model);
}

std::string Topics::ofJoint(const std::string& pattern, const std::string& joint) const {
  return filled(of(pattern), "joint", joint);
}

std::string Topics::ofSensor(const std::string& pattern, const config::SensorDescription& sensor) const {
  return filled(filled(of(pattern), "sensor", sensor.name), "link", sensor.link);
}

}  // namespace robotui::rt::hal::gazebo
