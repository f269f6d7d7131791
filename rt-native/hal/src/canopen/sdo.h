// Reads and writes objects of one drive by service data objects (CiA 301): a question and an answer, each bounded in
// time.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "bus.h"
#include "objects.h"

namespace robotui::rt::hal::canopen {

// The drive refused, or did not answer. The sentence names the object.
class SdoError : public std::runtime_error {
 public:
  SdoError(const std::string& what, std::uint32_t abort_code) : std::runtime_error(what), abort_code_(abort_code) {}
  // 0 where it did not answer.
  std::uint32_t abortCode() const noexcept { return abort_code_; }
  bool isNotThere() const noexcept { return abort_code_ == 0x0602'0000 || abort_code_ == 0x0609'0011; }

 private:
  std::uint32_t abort_code_;
};

// On ordinary threads: it waits. Objects of at most four bytes.
class SdoClient {
 public:
  SdoClient(const Bus& bus, std::uint8_t node, int timeout_ms) noexcept
      : bus_(bus), node_(node), timeout_ms_(timeout_ms) {}

  // Throw SdoError.
  std::uint32_t read(Object object) const;
  void write(Object object, std::uint32_t value, std::size_t size) const;

  // False where the drive has no such object.
  bool writeIfThere(Object object, std::uint32_t value, std::size_t size) const;

 private:
  Frame ask(const Frame& request, Object object) const;

  const Bus& bus_;
  std::uint8_t node_;
  int timeout_ms_;
};

// "0x6040:0"
std::string nameOf(Object object);

}  // namespace robotui::rt::hal::canopen
