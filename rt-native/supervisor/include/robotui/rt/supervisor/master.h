// The one client that commands the robot through the communication plugin.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "robotui/rt/link/command.h"
#include "robotui/rt/link/segment.h"

namespace robotui::rt::supervisor {

class Master {
 public:
  static constexpr std::int64_t kValidNs = 200'000'000;

  // `framework` is the one whose clients alone can take the robot.
  Master(std::uint32_t joints, std::string framework);

  // Empty, or a sentence. `seconds` without a reference end it.
  std::string take(std::uint64_t client, std::string_view framework, double seconds, std::int64_t now_ns);
  std::string release(std::uint64_t client);

  // Empty, or a sentence why the bytes are no references or the client is not the master.
  std::string reference(std::uint64_t client, std::string_view bytes, std::int64_t now_ns);

  // Also when a client is gone.
  void forget(std::uint64_t client);

  // True where the time of the master is over: said once.
  bool expire(std::int64_t now_ns);

  std::optional<std::uint64_t> holder() const noexcept { return holder_; }
  link::Descriptor share() const { return segment_.shareReadOnly(); }

 private:
  void end();

  std::uint32_t joints_;
  std::string framework_;
  link::Segment<link::MasterSegment> segment_;
  link::MasterWriter writer_;
  link::MasterData data_{};
  std::optional<std::uint64_t> holder_;
  std::int64_t patience_ns_ = 0;
  std::int64_t until_ns_ = 0;
};

}  // namespace robotui::rt::supervisor
