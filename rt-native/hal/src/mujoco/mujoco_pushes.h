// What users push a simulated robot with.
#pragma once

#include <array>

#include "mujoco_world.h"
#include "robotui/rt/link/push.h"
#include "robotui/rt/link/spsc_queue.h"

namespace robotui::rt::hal {

class MujocoPushes {
 public:
  // On the ordinary thread: empty, or a sentence why it is not done.
  std::string take(const link::Push& push, const MujocoWorld& world, double period);

  // On the real-time thread, once a cycle, and then before each step of the simulation.
  void begin() noexcept;
  void apply(const mjModel& model, mjData& data) noexcept;

 private:
  struct Acting {
    std::uint32_t number = 0;
    std::uint64_t cycles = 0;    // for which it still acts
    int dof = -1;                // of a joint
    int body = -1;               // of a link
    std::array<double, 3> at{};  // in the frame of the body
    std::array<double, 3> force{};
  };
  static void add(const Acting& acting, mjData& data) noexcept;

  link::SpscQueue<Acting, 32> taken_;
  std::array<Acting, link::kMostPushes> acting_{};
  bool acted_ = false;  // in the last step
};

}  // namespace robotui::rt::hal
