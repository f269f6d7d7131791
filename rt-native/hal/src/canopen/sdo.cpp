#include "sdo.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::hal::canopen {

namespace {

constexpr int kMostOld = 100'000;  // frames that came before the question
constexpr std::uint8_t kReadRequest = 0x40;
constexpr std::uint8_t kReadAnswer = 0x40;  // its upper three bits
constexpr std::uint8_t kWriteRequest = 0x22;
constexpr std::uint8_t kWriteAnswer = 0x60;
constexpr std::uint8_t kAbort = 0x80;
constexpr std::uint8_t kCommandBits = 0xe0;
constexpr std::uint8_t kExpedited = 0x02;
constexpr std::uint8_t kSized = 0x01;

struct Reason {
  std::uint32_t code;
  const char* text;
};

constexpr Reason kReasons[] = {
    {0x0504'0000, "it waited too long"},        {0x0601'0000, "it cannot be accessed so"},
    {0x0601'0001, "it can only be written"},    {0x0601'0002, "it can only be read"},
    {0x0602'0000, "it has no such object"},     {0x0604'0041, "the object cannot be mapped into a PDO"},
    {0x0604'0042, "the PDO would be too long"}, {0x0604'0043, "the parameters do not fit each other"},
    {0x0607'0010, "it has another length"},     {0x0607'0012, "the value is too long"},
    {0x0607'0013, "the value is too short"},    {0x0609'0011, "it has no such sub-index"},
    {0x0609'0030, "the value is out of range"}, {0x0609'0031, "the value is too great"},
    {0x0609'0032, "the value is too small"},    {0x0800'0020, "it cannot be stored"},
    {0x0800'0021, "it is locked by the drive"}, {0x0800'0022, "not in the present state of the drive"},
};

std::string reasonOf(std::uint32_t code) {
  const auto* const found =
      std::find_if(std::begin(kReasons), std::end(kReasons), [&](const Reason& each) { return each.code == code; });
  std::array<char, 16> number{};
  std::snprintf(number.data(), number.size(), "0x%08X", code);
  return (found == std::end(kReasons) ? std::string("abort code ") : std::string(found->text) + ", ") + number.data();
}

Frame requestOf(std::uint8_t command, std::uint8_t node, Object object) noexcept {
  return frameOf(kSdoRequestId + node, {command, static_cast<std::uint8_t>(object.index & 0xff),
                                        static_cast<std::uint8_t>(object.index >> 8), object.sub, 0, 0, 0, 0});
}

bool isAnswer(const Frame& frame, std::uint8_t node, Object object) noexcept {
  return isPlain(frame) && frame.can_id == kSdoAnswerId + node && frame.can_dlc == CAN_MAX_DLEN &&
         get(frame, 1, 2) == object.index && frame.data[3] == object.sub;
}

}  // namespace

std::string nameOf(Object object) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "0x%04X:%u", object.index, object.sub);
  return text.data();
}

// Answers to older questions, and of other nodes, are passed over.
Frame SdoClient::ask(const Frame& request, Object object) const {
  Frame frame{};
  for (int i = 0; i < kMostOld && bus_.receive(frame) == Heard::kFrame; ++i) {
  }
  Sent sent = bus_.send(request);
  const std::int64_t end = link::now() + timeout_ms_ * link::kMillisecond;
  while (link::now() < end && sent != Sent::kDown) {
    if (sent == Sent::kFull) sent = bus_.send(request);
    bus_.wait(static_cast<int>((end - link::now()) / link::kMillisecond) + 1);
    Heard heard = Heard::kNothing;
    while ((heard = bus_.receive(frame)) == Heard::kFrame) {
      if (!isAnswer(frame, node_, object)) continue;
      if (frame.data[0] != kAbort) return frame;
      const std::uint32_t code = get(frame, 4, 4);
      throw SdoError("it refuses " + nameOf(object) + ": " + reasonOf(code), code);
    }
    if (heard == Heard::kDown) break;
  }
  throw SdoError("it does not answer to " + nameOf(object) + " within " + std::to_string(timeout_ms_) + " ms", 0);
}

std::uint32_t SdoClient::read(Object object) const {
  const Frame answer = ask(requestOf(kReadRequest, node_, object), object);
  const std::uint8_t command = answer.data[0];
  if ((command & kCommandBits) != kReadAnswer || (command & kExpedited) == 0)
    throw SdoError("it answers to " + nameOf(object) + " with more than four bytes", 0);
  const std::size_t unused = (command & kSized) != 0 ? (command >> 2U) & 3U : 0;
  return get(answer, 4, 4 - unused);
}

void SdoClient::write(Object object, std::uint32_t value, std::size_t size) const {
  Frame request = requestOf(static_cast<std::uint8_t>(kWriteRequest | kSized | ((4 - size) << 2U)), node_, object);
  put(request, 4, size, value);
  if ((ask(request, object).data[0] & kCommandBits) != kWriteAnswer)
    throw SdoError("it answers to the writing of " + nameOf(object) + " with something else", 0);
}

bool SdoClient::writeIfThere(Object object, std::uint32_t value, std::size_t size) const {
  try {
    write(object, value, size);
    return true;
  } catch (const SdoError& error) {
    if (!error.isNotThere()) throw;
    return false;
  }
}

}  // namespace robotui::rt::hal::canopen
