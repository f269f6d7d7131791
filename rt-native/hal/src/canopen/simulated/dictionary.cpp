#include "dictionary.h"

namespace robotui::rt::hal::canopen::simulated {

namespace {

constexpr std::uint32_t kReadOnly = 0x0601'0002;
constexpr std::uint32_t kNoObject = 0x0602'0000;
constexpr std::uint32_t kNotMappable = 0x0604'0041;
constexpr std::uint32_t kPdoTooLong = 0x0604'0042;
constexpr std::uint32_t kOtherLength = 0x0607'0010;
constexpr std::uint32_t kNotNow = 0x0800'0022;
constexpr std::uint32_t kUnknownCommand = 0x0504'0001;
constexpr std::size_t kPdos = 4;
constexpr std::uint8_t kMostEntries = 8;

Object at(std::uint16_t first, std::size_t pdo, std::uint8_t sub) noexcept {
  return {static_cast<std::uint16_t>(first + pdo), sub};
}

bool isIn(std::uint16_t index, std::uint16_t first) noexcept { return index >= first && index < first + kPdos; }

std::uint32_t entryOf(Object object, std::size_t bytes) noexcept {
  return std::uint32_t{object.index} << 16U | std::uint32_t{object.sub} << 8U | static_cast<std::uint32_t>(bytes * 8);
}

Frame abortOf(std::uint8_t node, Object object, std::uint32_t code) noexcept {
  Frame frame = frameOf(kSdoAnswerId + node, {0x80, static_cast<std::uint8_t>(object.index & 0xff),
                                              static_cast<std::uint8_t>(object.index >> 8U), object.sub, 0, 0, 0, 0});
  put(frame, 4, 4, code);
  return frame;
}

}  // namespace

Dictionary::Dictionary(std::uint8_t node) : node_(node) {
  add(kDeviceType, 4, Access::kRead, 0x0002'0000 | kDriveProfile);
  add({0x1001}, 1, Access::kRead);
  add(kSyncIdentifier, 4, Access::kWrite, kSyncId);
  add(kCyclePeriod, 4, Access::kWrite);
  add(kHeartbeatConsumer, 4, Access::kWrite);
  add(kHeartbeatProducer, 2, Access::kWrite);
  add({0x1018, 1}, 4, Access::kRead, 0x1234);
  addPdos();
  addDrive();
}

void Dictionary::addPdos() {
  for (std::size_t pdo = 0; pdo < kPdos; ++pdo) {
    const auto number = static_cast<std::uint32_t>(0x100 * pdo + node_);
    const std::uint32_t off = pdo == 0 ? 0 : kPdoOff;
    for (const auto& [parameters, mapping, id] :
         {std::tuple{kReceivePdo, kReceiveMapping, 0x200U}, {kTransmitPdo, kTransmitMapping, 0x180U}}) {
      add(at(parameters, pdo, 1), 4, Access::kWrite, (id + number) | off);
      add(at(parameters, pdo, 2), 1, Access::kWrite, 1);
      add(at(mapping, pdo, 0), 1, Access::kWrite);
      for (std::uint8_t sub = 1; sub <= kMostEntries; ++sub) add(at(mapping, pdo, sub), 4, Access::kWrite);
    }
  }
  set(at(kReceiveMapping, 0, 0), 2);
  set(at(kReceiveMapping, 0, 1), entryOf(kControlWord, 2));
  set(at(kReceiveMapping, 0, 2), entryOf(kTargetPosition, 4));
  set(at(kTransmitMapping, 0, 0), 2);
  set(at(kTransmitMapping, 0, 1), entryOf(kStatusWord, 2));
  set(at(kTransmitMapping, 0, 2), entryOf(kPositionActual, 4));
}

void Dictionary::addDrive() {
  add(kErrorCode, 2, Access::kRead);
  add(kControlWord, 2, Access::kWrite);
  add(kStatusWord, 2, Access::kRead);
  add(kMode, 1, Access::kWrite);
  add(kModeShown, 1, Access::kRead);
  add(kPositionActual, 4, Access::kRead);
  add({0x6065}, 4, Access::kWrite, 2000);
  add(kVelocityActual, 4, Access::kRead);
  add(kTargetTorque, 2, Access::kWrite);
  add(kTorqueActual, 2, Access::kRead);
  add(kTargetPosition, 4, Access::kWrite);
  add(kDigitalInputs, 4, Access::kRead, 0xffff'0000);
  add(kLeastPosition, 4, Access::kWrite, 0x8000'0000);
  add(kMostPosition, 4, Access::kWrite, 0x7fff'ffff);
  add(kInterpolationPeriod, 1, Access::kWrite, 1);
  add(kInterpolationExponent, 1, Access::kWrite, 0xfd);
  add(kTargetVelocity, 4, Access::kWrite);
}

void Dictionary::add(Object object, std::size_t size, Access access, std::uint32_t value) {
  entries_[keyOf(object)] = {static_cast<std::uint8_t>(size), access, value};
}

std::uint32_t Dictionary::get(Object object) const noexcept {
  const auto found = entries_.find(keyOf(object));
  return found == entries_.end() ? 0 : found->second.value;
}

void Dictionary::set(Object object, std::uint32_t value) noexcept {
  if (const auto found = entries_.find(keyOf(object)); found != entries_.end()) found->second.value = value;
}

std::size_t Dictionary::sizeOf(Object object) const noexcept {
  const auto found = entries_.find(keyOf(object));
  return found == entries_.end() ? 0 : found->second.size;
}

// A mapping is written while its PDO is off, its entries while their number is 0.
std::uint32_t Dictionary::objectionToMapping(Object object, std::uint32_t value) const {
  const bool received = isIn(object.index, kReceiveMapping);
  const std::uint16_t mapping = received ? kReceiveMapping : kTransmitMapping;
  const auto pdo = static_cast<std::size_t>(object.index - mapping);
  if ((get(at(received ? kReceivePdo : kTransmitPdo, pdo, 1)) & kPdoOff) == 0) return kNotNow;
  if (object.sub > 0) {
    if (get({object.index, 0}) != 0) return kNotNow;
    const Object mapped{static_cast<std::uint16_t>(value >> 16U), static_cast<std::uint8_t>(value >> 8U)};
    return sizeOf(mapped) * 8 == (value & 0xffU) ? 0 : kNotMappable;
  }
  if (value > kMostEntries) return kPdoTooLong;
  std::uint32_t bits = 0;
  for (std::uint8_t sub = 1; sub <= value; ++sub) bits += get({object.index, sub}) & 0xffU;
  return bits <= 64 ? 0 : kPdoTooLong;
}

std::uint32_t Dictionary::objection(Object object, std::uint32_t value) const {
  return isIn(object.index, kReceiveMapping) || isIn(object.index, kTransmitMapping) ? objectionToMapping(object, value)
                                                                                     : 0;
}

std::uint32_t Dictionary::write(Object object, std::size_t size, std::uint32_t value) {
  const auto found = entries_.find(keyOf(object));
  if (found == entries_.end()) return kNoObject;
  if (found->second.access == Access::kRead) return kReadOnly;
  if (found->second.size != size) return kOtherLength;
  if (const std::uint32_t code = objection(object, value); code != 0) return code;
  found->second.value = value;
  return 0;
}

Frame Dictionary::answer(const Frame& request) {
  const Object object{static_cast<std::uint16_t>(canopen::get(request, 1, 2)), request.data[3]};
  const std::uint8_t command = request.data[0];
  Frame answer = abortOf(node_, object, kUnknownCommand);
  if (command == 0x40) {
    const std::size_t size = sizeOf(object);
    if (size == 0) return abortOf(node_, object, kNoObject);
    answer.data[0] = static_cast<std::uint8_t>(0x43U | ((4 - size) << 2U));
    put(answer, 4, 4, get(object));
  } else if ((command & 0xe3U) == 0x23) {
    const std::size_t size = 4 - ((command >> 2U) & 3U);
    const std::uint32_t code = write(object, size, canopen::get(request, 4, size));
    if (code != 0) return abortOf(node_, object, code);
    answer.data[0] = 0x60;
    put(answer, 4, 4, 0);
  }
  return answer;
}

}  // namespace robotui::rt::hal::canopen::simulated
