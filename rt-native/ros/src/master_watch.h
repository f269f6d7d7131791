// Looks every second whether the ROS master is there and knows this node: a master that was started anew knows nobody.
#pragma once

#include <atomic>
#include <thread>

namespace robotui::rt::ros_bridge {

class MasterWatch {
 public:
  MasterWatch();
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  // True once after the node was found to be unknown; then it must register again.
  bool takeForgotten() noexcept { return forgotten_.exchange(false); }

 private:
  void watch();

  std::atomic<bool> forgotten_{false};
  std::atomic<bool> going_{true};
  std::thread thread_;  // a master that hangs must not stop the topics of the robot
};

}  // namespace robotui::rt::ros_bridge
