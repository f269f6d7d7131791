// A push by a user on a robot that is simulated, as a hand would give it: from the supervisor to the HAL.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace robotui::rt::link {

inline constexpr std::uint32_t kMostPushes = 8;   // at the same time
inline constexpr double kLongestPush = 60;        // s
inline constexpr double kMostPushingForce = 1e3;  // N on a link; on a joint it is the joint's limit of effort

struct Push {
  std::uint32_t number = 0;              // below kMostPushes: it takes the place of what that one did
  double seconds = 0;                    // from now on; 0 ends it
  std::optional<std::uint32_t> joint;    // acts on this joint, by its index
  std::string link;                      // where there is no joint: acts at the origin of this link
  std::array<double, 3> force{0, 0, 0};  // N m or N on a joint: the first number; on a link N in the axes of the world
};

// A packet of the socket: "push NUMBER SECONDS joint INDEX EFFORT", or "push NUMBER SECONDS link X Y Z NAME".
std::string textOf(const Push& push);

// Nothing where the words behind the verb are not those of a push, or beyond what is allowed.
std::optional<Push> pushOf(std::string_view words);

}  // namespace robotui::rt::link
