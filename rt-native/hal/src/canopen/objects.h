// Objects of a drive's dictionary (CiA 301 and CiA 402) that we use.
#pragma once

#include <cstdint>

namespace robotui::rt::hal::canopen {

struct Object {
  std::uint16_t index;
  std::uint8_t sub = 0;
  friend bool operator==(const Object&, const Object&) = default;
};

inline constexpr Object kDeviceType{0x1000};
inline constexpr Object kSyncIdentifier{0x1005};
inline constexpr Object kCyclePeriod{0x1006};  // us
inline constexpr Object kHeartbeatConsumer{0x1016, 1};
inline constexpr Object kHeartbeatProducer{0x1017};  // ms
inline constexpr std::uint16_t kReceivePdo = 0x1400;
inline constexpr std::uint16_t kReceiveMapping = 0x1600;
inline constexpr std::uint16_t kTransmitPdo = 0x1800;
inline constexpr std::uint16_t kTransmitMapping = 0x1a00;

inline constexpr Object kErrorCode{0x603f};
inline constexpr Object kControlWord{0x6040};
inline constexpr Object kStatusWord{0x6041};
inline constexpr Object kMode{0x6060};
inline constexpr Object kModeShown{0x6061};
inline constexpr Object kPositionActual{0x6064};
inline constexpr Object kVelocityActual{0x606c};
inline constexpr Object kTargetTorque{0x6071};
inline constexpr Object kTorqueActual{0x6077};
inline constexpr Object kTargetPosition{0x607a};
inline constexpr Object kLeastPosition{0x607d, 1};
inline constexpr Object kMostPosition{0x607d, 2};
inline constexpr Object kInterpolationPeriod{0x60c2, 1};
inline constexpr Object kInterpolationExponent{0x60c2, 2};
inline constexpr Object kDigitalInputs{0x60fd};
inline constexpr Object kTargetVelocity{0x60ff};

inline constexpr std::uint32_t kDriveProfile = 402;  // low half of kDeviceType
inline constexpr std::uint32_t kPdoOff = 0x8000'0000;
inline constexpr std::uint32_t kPdoNoRemote = 0x4000'0000;

enum class OperationMode : std::int8_t { kNone = 0, kSyncPosition = 8, kSyncVelocity = 9, kSyncTorque = 10 };

}  // namespace robotui::rt::hal::canopen
