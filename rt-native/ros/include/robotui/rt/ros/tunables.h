// Parameters that users change while the plugin runs (dynamic_reconfigure): plain numbers that change between two
// loops.
#pragma once

#include <cmath>
#include <functional>
#include <memory>

#include "robotui/rt/ros/announcement.h"

namespace robotui::rt::ros {

// A parameter of type bool, int or double. Read it in the control loop: it changes only in Node::spin().
template <typename T>
class Tunable {
 public:
  Tunable() = default;
  explicit Tunable(const double* value) : value_(value) {}
  T get() const noexcept { return static_cast<T>(*value_); }
  operator T() const noexcept { return get(); }

 private:
  const double* value_ = nullptr;
};

class Tunables {
 public:
  static constexpr std::size_t kMost = 64;

  Tunables() : values_(std::make_unique<std::array<double, kMost>>()) {}

  // Throws std::runtime_error where there are too many.
  const double* add(TunableEntry entry) {
    if (entries_.size() == kMost)
      throw std::runtime_error("A plugin can have " + std::to_string(kMost) + " tunable parameters.");
    entries_.push_back(std::move(entry));
    (*values_)[entries_.size() - 1] = entries_.back().initial;
    return &(*values_)[entries_.size() - 1];
  }

  const std::vector<TunableEntry>& entries() const noexcept { return entries_; }

  // In the control loop: takes what has come, within the limits, and tells what holds now.
  void apply(PacketReader& from, std::uint64_t generation, PacketWriter& to) noexcept {
    bool any = false;
    std::uint32_t number = 0;
    while (from.next()) {
      if (from.flags() != generation || from.bytes().size() != entries_.size() * sizeof(double)) continue;
      number = from.number();
      for (std::size_t i = 0; i < entries_.size(); ++i) set(i, from.bytes().data() + i * sizeof(double));
      any = true;
    }
    if (any) tell(to, number);
  }

  void tell(PacketWriter& to, std::uint32_t number) noexcept {
    const std::size_t size = entries_.size() * sizeof(double);
    to.write(size, number, 0, [&](std::uint8_t* into) { std::memcpy(into, values_->data(), size); });
  }

 private:
  void set(std::size_t i, const std::uint8_t* at) noexcept {
    double value = 0;
    std::memcpy(&value, at, sizeof(value));
    if (!std::isfinite(value)) return;
    const TunableEntry& entry = entries_[i];
    value = std::clamp(value, entry.least, entry.most);
    (*values_)[i] = entry.type == TunableType::kDouble ? value : std::round(value);
  }

  std::vector<TunableEntry> entries_;
  std::unique_ptr<std::array<double, kMost>> values_;  // Tunable points into it
};

}  // namespace robotui::rt::ros
