// What a plugin says once of each of its ports, so that the ROS process can offer it: written in init, read by a
// process that believes nothing.
#pragma once

#include <optional>
#include <stdexcept>
#include <vector>

#include "robotui/rt/ros/packet.h"

namespace robotui::rt::ros {

enum class TunableType : std::uint8_t { kBool = 1, kInt = 2, kDouble = 3 };

struct TunableEntry {
  std::string name;
  std::string description;
  TunableType type = TunableType::kDouble;
  double initial = 0;
  double least = 0;
  double most = 0;
};

struct Announcement {
  PortKind kind = PortKind::kPublish;
  bool large = false;
  bool latched = false;
  std::uint64_t generation = 0;  // of the plugin's life: packets of another one do not count
  std::string name;              // of topic or service, as ROS resolves it
  std::string type;
  std::string md5;
  std::string definition;  // of the message, or of the request
  std::vector<TunableEntry> tunables;
};

namespace detail {

class Bytes {
 public:
  void put(const std::string& text) {
    number(text.size());
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }
  template <typename T>
  void number(T value) {
    const auto* at = reinterpret_cast<const std::uint8_t*>(&value);
    bytes_.insert(bytes_.end(), at, at + sizeof(value));
  }
  const std::vector<std::uint8_t>& get() const noexcept { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

class BytesReader {
 public:
  explicit BytesReader(std::span<const std::uint8_t> bytes) : left_(bytes) {}
  template <typename T>
  T number() {
    T value{};
    if (left_.size() < sizeof(value)) throw std::runtime_error("an announcement is cut");
    std::memcpy(&value, left_.data(), sizeof(value));
    left_ = left_.subspan(sizeof(value));
    return value;
  }
  std::string text() {
    const auto length = number<std::size_t>();
    if (left_.size() < length) throw std::runtime_error("an announcement is cut");
    std::string result(left_.begin(), left_.begin() + static_cast<std::ptrdiff_t>(length));
    left_ = left_.subspan(length);
    return result;
  }

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace detail

inline std::vector<std::uint8_t> write(const Announcement& port) {
  detail::Bytes bytes;
  bytes.number(port.kind);
  bytes.number(std::uint8_t{port.large});
  bytes.number(std::uint8_t{port.latched});
  bytes.number(port.generation);
  for (const auto* text : {&port.name, &port.type, &port.md5, &port.definition}) bytes.put(*text);
  bytes.number(port.tunables.size());
  for (const TunableEntry& each : port.tunables) {
    bytes.put(each.name);
    bytes.put(each.description);
    bytes.number(each.type);
    for (const double value : {each.initial, each.least, each.most}) bytes.number(value);
  }
  return bytes.get();
}

// Throws std::runtime_error where the bytes are none.
inline Announcement readAnnouncement(std::span<const std::uint8_t> from) {
  detail::BytesReader bytes(from);
  Announcement port;
  port.kind = bytes.number<PortKind>();
  port.large = bytes.number<std::uint8_t>() != 0;
  port.latched = bytes.number<std::uint8_t>() != 0;
  port.generation = bytes.number<std::uint64_t>();
  for (auto* text : {&port.name, &port.type, &port.md5, &port.definition}) *text = bytes.text();
  const auto tunables = bytes.number<std::size_t>();
  for (std::size_t i = 0; i < tunables; ++i) {
    TunableEntry each;
    each.name = bytes.text();
    each.description = bytes.text();
    each.type = bytes.number<TunableType>();
    for (auto* value : {&each.initial, &each.least, &each.most}) *value = bytes.number<double>();
    port.tunables.push_back(std::move(each));
  }
  return port;
}

}  // namespace robotui::rt::ros
