// A bus of simulated drives that other programs of this computer can join: each message of its socket is one frame.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../bus.h"
#include "drive.h"

namespace robotui::rt::hal::canopen::simulated {

// On one thread.
class SimulatedBus {
 public:
  // `interface` is unix:PATH, a socket that is made here and where others join, or an interface of the kernel. Throws
  // std::runtime_error.
  explicit SimulatedBus(const std::string& interface);
  ~SimulatedBus();
  SimulatedBus(const SimulatedBus&) = delete;
  SimulatedBus& operator=(const SimulatedBus&) = delete;

  Drive& add(std::uint8_t node, double position_counts);
  std::size_t drives() const noexcept { return drives_.size(); }
  Drive& drive(std::size_t index) { return *drives_[index]; }

  // Passes on what comes, for `timeout_ms` at most where nothing does.
  void step(int timeout_ms);

  // To all who joined, as if another node had sent it.
  void send(const Frame& frame);
  std::size_t members() const noexcept { return members_.size(); }

 private:
  void wait(int timeout_ms) const;
  void join();
  bool pass(std::size_t member);

  std::string path_;  // empty on a bus of the kernel
  link::Descriptor door_;
  std::vector<Bus> members_;
  std::vector<std::unique_ptr<Drive>> drives_;
};

}  // namespace robotui::rt::hal::canopen::simulated
