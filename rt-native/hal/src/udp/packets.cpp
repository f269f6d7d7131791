#include "packets.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace robotui::rt::hal::udp {

namespace {

template <class T>
T at(std::span<const std::byte> packet, std::size_t offset, std::size_t index) noexcept {
  T value;
  std::memcpy(&value, packet.data() + offset + index * sizeof(T), sizeof(T));
  return value;
}

template <class T>
void put(Buffer& buffer, std::size_t& offset, const T& value) noexcept {
  std::memcpy(buffer.data() + offset, &value, sizeof(T));
  offset += sizeof(T);
}

template <class T>
bool areFinite(std::span<const T> values) noexcept {
  return std::all_of(values.begin(), values.end(), [](T value) { return std::isfinite(value); });
}

bool isSound(const JointReference& r) noexcept {
  return areFinite<double>(std::array{r.position, r.velocity, r.effort, r.stiffness, r.damping});
}

bool isSound(const JointMeasurement& m) noexcept {
  return areFinite<double>(std::array{m.link_position, m.motor_position, m.link_velocity, m.motor_velocity, m.effort});
}

bool isSound(const link::ImuState& imu) noexcept {
  return areFinite<double>(imu.orientation) && areFinite<double>(imu.angular_velocity) &&
         areFinite<double>(imu.linear_acceleration);
}

bool isSound(const link::ForceTorqueState& sensor) noexcept {
  return areFinite<double>(sensor.force) && areFinite<double>(sensor.torque);
}

// All that follow from `offset` are numbers.
template <class T>
bool allSound(std::span<const std::byte> packet, std::size_t offset, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    if (!isSound(at<T>(packet, offset, i))) return false;
  }
  return true;
}

void copy(const JointMeasurement& from, link::JointState& to) noexcept {
  to.link_position = from.link_position;
  to.motor_position = from.motor_position;
  to.link_velocity = from.link_velocity;
  to.motor_velocity = from.motor_velocity;
  to.effort = from.effort;
  to.temperature_motor = from.temperature_motor;
  to.temperature_driver = from.temperature_driver;
  to.fault = from.fault;
}

Header complete(Header header, Kind kind) noexcept {
  header.magic = kMagic;
  header.version = kVersion;
  header.kind = static_cast<std::uint16_t>(kind);
  return header;
}

}  // namespace

std::size_t sizeOf(const Header& header) noexcept {
  switch (static_cast<Kind>(header.kind)) {
    case Kind::kHello: return sizeof(Header);
    case Kind::kCommand: return sizeof(Header) + header.joints * sizeof(JointReference);
    case Kind::kState:
      return sizeof(Header) + header.joints * sizeof(JointMeasurement) + header.imus * sizeof(link::ImuState) +
             header.force_torques * sizeof(link::ForceTorqueState);
  }
  return 0;
}

bool read(std::span<const std::byte> packet, Header& into) noexcept {
  if (packet.size() < sizeof(Header)) return false;
  into = at<Header>(packet, 0, 0);
  return into.magic == kMagic && into.version == kVersion && packet.size() == sizeOf(into);
}

bool readReferences(std::span<const std::byte> packet, std::span<Reference> into) noexcept {
  if (packet.size() != sizeof(Header) + into.size() * sizeof(JointReference)) return false;
  if (!allSound<JointReference>(packet, sizeof(Header), into.size())) return false;
  for (std::size_t i = 0; i < into.size(); ++i) {
    const auto wire = at<JointReference>(packet, sizeof(Header), i);
    into[i] = {wire.position, wire.velocity, wire.effort, wire.stiffness, wire.damping, wire.mode};
  }
  return true;
}

bool readState(std::span<const std::byte> packet, Measurements& into) noexcept {
  const std::size_t imus = sizeof(Header) + into.joints.size() * sizeof(JointMeasurement);
  const std::size_t sensors = imus + into.imus.size() * sizeof(link::ImuState);
  if (packet.size() != sensors + into.force_torques.size() * sizeof(link::ForceTorqueState)) return false;
  if (!allSound<JointMeasurement>(packet, sizeof(Header), into.joints.size()) ||
      !allSound<link::ImuState>(packet, imus, into.imus.size()) ||
      !allSound<link::ForceTorqueState>(packet, sensors, into.force_torques.size())) {
    return false;
  }
  for (std::size_t i = 0; i < into.joints.size(); ++i)
    copy(at<JointMeasurement>(packet, sizeof(Header), i), into.joints[i]);
  for (std::size_t i = 0; i < into.imus.size(); ++i) into.imus[i] = at<link::ImuState>(packet, imus, i);
  for (std::size_t i = 0; i < into.force_torques.size(); ++i)
    into.force_torques[i] = at<link::ForceTorqueState>(packet, sensors, i);
  return true;
}

std::span<const std::byte> writeHello(Buffer& buffer, Header header) noexcept {
  std::size_t end = 0;
  put(buffer, end, complete(header, Kind::kHello));
  return std::span(buffer).first(end);
}

std::span<const std::byte> writeCommand(Buffer& buffer, Header header, std::span<const Reference> references) noexcept {
  header.joints = static_cast<std::uint16_t>(references.size());
  header.imus = header.force_torques = 0;
  std::size_t end = 0;
  put(buffer, end, complete(header, Kind::kCommand));
  for (const Reference& r : references)
    put(buffer, end, JointReference{r.position, r.velocity, r.effort, r.stiffness, r.damping, r.mode, {}});
  return std::span(buffer).first(end);
}

std::span<const std::byte> writeState(Buffer& buffer, Header header, const Measurements& measured) noexcept {
  header.joints = static_cast<std::uint16_t>(measured.joints.size());
  header.imus = static_cast<std::uint16_t>(measured.imus.size());
  header.force_torques = static_cast<std::uint16_t>(measured.force_torques.size());
  std::size_t end = 0;
  put(buffer, end, complete(header, Kind::kState));
  for (const link::JointState& j : measured.joints) {
    put(buffer, end,
        JointMeasurement{j.link_position, j.motor_position, j.link_velocity, j.motor_velocity, j.effort,
                         j.temperature_motor, j.temperature_driver, j.fault, 0});
  }
  for (const link::ImuState& imu : measured.imus) put(buffer, end, imu);
  for (const link::ForceTorqueState& sensor : measured.force_torques) put(buffer, end, sensor);
  return std::span(buffer).first(end);
}

}  // namespace robotui::rt::hal::udp
