#include "pdo_layout.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <vector>

#include "sdo.h"

namespace robotui::rt::hal::canopen {

namespace {

constexpr std::uint8_t kMostEntries = 64;
constexpr std::uint32_t kEachSync = 1;      // the type of transmission
constexpr std::uint32_t kLastCyclic = 240;  // of the types that answer to SYNC

struct Entry {
  Object object;
  std::uint8_t size;  // bytes
};

struct Direction {
  std::uint16_t parameters;
  std::uint16_t mapping;
  canid_t first_id;
  const char* name;
};

constexpr Direction kReceive{kReceivePdo, kReceiveMapping, 0x200, "RPDO"};
constexpr Direction kTransmit{kTransmitPdo, kTransmitMapping, 0x180, "TPDO"};

Object inPdo(std::uint16_t first, std::size_t pdo, std::uint8_t sub) noexcept {
  return {static_cast<std::uint16_t>(first + pdo), sub};
}

struct Wanted {
  Object object;
  Field PdoLayout::*field;
  std::uint8_t size;
};

constexpr Wanted kReceived[] = {{kControlWord, &PdoLayout::control_word, 2},
                                {kMode, &PdoLayout::mode, 1},
                                {kTargetPosition, &PdoLayout::target_position, 4},
                                {kTargetVelocity, &PdoLayout::target_velocity, 4},
                                {kTargetTorque, &PdoLayout::target_torque, 2}};
constexpr Wanted kTransmitted[] = {
    {kStatusWord, &PdoLayout::status_word, 2},  {kModeShown, &PdoLayout::mode_shown, 1},
    {kPositionActual, &PdoLayout::position, 4}, {kVelocityActual, &PdoLayout::velocity, 4},
    {kTorqueActual, &PdoLayout::torque, 2},     {kDigitalInputs, &PdoLayout::inputs, 4}};

// Objects that we do not know are passed over; ours must be whole bytes of the size that CiA 402 says.
void place(PdoLayout& layout, std::span<const Wanted> known, std::uint32_t entry, std::size_t pdo, unsigned bits) {
  const Object object{static_cast<std::uint16_t>(entry >> 16U), static_cast<std::uint8_t>(entry >> 8U)};
  const auto found =
      std::find_if(known.begin(), known.end(), [&](const Wanted& each) { return each.object == object; });
  if (found == known.end()) return;
  if (bits % 8 != 0 || (entry & 0xffU) != found->size * 8U)
    throw std::runtime_error("its PDO has " + nameOf(object) + " in an unusual place or size");
  layout.*(found->field) = {static_cast<std::uint8_t>(pdo), static_cast<std::uint8_t>(bits / 8), found->size};
}

// A PDO that does not answer to SYNC, or is switched off, is not used.
bool isUsed(const SdoClient& sdo, const Direction& direction, std::size_t pdo, std::uint32_t& id) {
  try {
    id = sdo.read(inPdo(direction.parameters, pdo, 1));
  } catch (const SdoError& error) {
    if (!error.isNotThere()) throw;
    return false;
  }
  if ((id & kPdoOff) != 0 || (id & CAN_SFF_MASK) == 0) return false;
  const std::uint32_t type = sdo.read(inPdo(direction.parameters, pdo, 2));
  if (type <= kEachSync || &direction == &kReceive) return true;
  if (type <= kLastCyclic)
    throw std::runtime_error(std::string(direction.name) + std::to_string(pdo + 1) + " answers to each " +
                             std::to_string(type) + "th SYNC only");
  return false;
}

void readPdo(const SdoClient& sdo, const Direction& direction, std::size_t pdo, PdoLayout& layout) {
  std::uint32_t id = 0;
  if (!isUsed(sdo, direction, pdo, id)) return;
  const bool received = direction.parameters == kReceivePdo;
  const std::uint32_t entries = std::min<std::uint32_t>(sdo.read(inPdo(direction.mapping, pdo, 0)), kMostEntries);
  unsigned bits = 0;
  for (std::uint32_t i = 1; i <= entries; ++i) {
    const std::uint32_t entry = sdo.read(inPdo(direction.mapping, pdo, static_cast<std::uint8_t>(i)));
    place(layout, received ? std::span<const Wanted>(kReceived) : kTransmitted, entry, pdo, bits);
    bits += entry & 0xffU;
  }
  if (bits > 8 * CAN_MAX_DLEN) throw std::runtime_error("its PDO is longer than 8 bytes");
  if (bits == 0) return;
  (received ? layout.receive : layout.transmit)[pdo] = {id & CAN_SFF_MASK, static_cast<std::uint8_t>((bits + 7) / 8)};
}

void need(const Field& field, Object object, const char* direction) {
  if (!field.isThere())
    throw std::runtime_error("none of its " + std::string(direction) + " carries " + nameOf(object) +
                             ": map it there, or write mapping: write");
}

void check(const PdoLayout& layout, const Ways& ways) {
  need(layout.control_word, kControlWord, "RPDOs");
  need(layout.status_word, kStatusWord, "TPDOs that answer to SYNC");
  need(layout.position, kPositionActual, "TPDOs that answer to SYNC");
  if (ways.inputs) need(layout.inputs, kDigitalInputs, "TPDOs that answer to SYNC");
  if (ways.position) need(layout.target_position, kTargetPosition, "RPDOs");
  if (ways.velocity) need(layout.target_velocity, kTargetVelocity, "RPDOs");
  if (ways.effort) need(layout.target_torque, kTargetTorque, "RPDOs");
  if (ways.count() > 1) need(layout.mode, kMode, "RPDOs");
}

void writePdo(const SdoClient& sdo, const Direction& direction, std::uint8_t node, std::size_t pdo,
              std::span<const Entry> entries) {
  const auto id = static_cast<std::uint32_t>(direction.first_id + 0x100 * pdo + node);
  const Object identifier = inPdo(direction.parameters, pdo, 1);
  const Object count = inPdo(direction.mapping, pdo, 0);
  if (entries.empty()) {  // also where the drive has fewer PDOs
    sdo.writeIfThere(identifier, id | kPdoOff, 4);
    return;
  }
  sdo.write(identifier, id | kPdoOff, 4);
  sdo.write(inPdo(direction.parameters, pdo, 2), kEachSync, 1);
  sdo.write(count, 0, 1);
  std::uint8_t sub = 0;
  for (const Entry& entry : entries)
    sdo.write(inPdo(direction.mapping, pdo, ++sub),
              std::uint32_t{entry.object.index} << 16U | std::uint32_t{entry.object.sub} << 8U | entry.size * 8U, 4);
  sdo.write(count, sub, 1);
  sdo.write(identifier, direction.first_id == kTransmit.first_id ? id | kPdoNoRemote : id, 4);
}

}  // namespace

std::size_t PdoLayout::frames() const noexcept {
  const auto used = [](const Pdo& pdo) { return pdo.id != 0; };
  return static_cast<std::size_t>(std::count_if(receive.begin(), receive.end(), used) +
                                  std::count_if(transmit.begin(), transmit.end(), used));
}

PdoLayout readLayout(const SdoClient& sdo, const Ways& ways) {
  PdoLayout layout{};
  for (std::size_t pdo = 0; pdo < kPdos; ++pdo) {
    readPdo(sdo, kReceive, pdo, layout);
    readPdo(sdo, kTransmit, pdo, layout);
  }
  check(layout, ways);
  return layout;
}

void writeLayout(const SdoClient& sdo, std::uint8_t node, const Ways& ways) {
  std::vector<Entry> first{{kControlWord, 2}};
  if (ways.count() > 1) first.push_back({kMode, 1});
  if (ways.position) first.push_back({kTargetPosition, 4});
  std::vector<Entry> second;
  if (ways.velocity) second.push_back({kTargetVelocity, 4});
  if (ways.effort) second.push_back({kTargetTorque, 2});
  const std::vector<Entry> state{{kStatusWord, 2}, {kModeShown, 1}, {kPositionActual, 4}};
  const std::vector<Entry> motion{{kVelocityActual, 4}, {kTorqueActual, 2}};
  std::vector<Entry> inputs;
  if (ways.inputs) inputs.push_back({kDigitalInputs, 4});
  const std::vector<Entry> none;
  for (std::size_t pdo = 0; pdo < kPdos; ++pdo) {
    writePdo(sdo, kReceive, node, pdo, pdo == 0 ? first : pdo == 1 ? second : none);
    writePdo(sdo, kTransmit, node, pdo, pdo == 0 ? state : pdo == 1 ? motion : pdo == 2 ? inputs : none);
  }
}

}  // namespace robotui::rt::hal::canopen
