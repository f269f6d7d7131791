// Looks whether the simulator is there, and says what is wrong and what would help. On the ordinary thread.
#pragma once

#include <memory>

#include "joint_inbox.h"
#include "sensor_inbox.h"
#include "settings.h"
#include "transport.h"
#include "world_inbox.h"

namespace robotui::rt::hal::gazebo {

// Where the first state did not come: the sentence of the error.
std::string whyNoState(const FirstState& first, const Settings& settings, const std::string& topic,
                       const std::string& joint, const Transport& transport);

class Watch {
 public:
  Watch(const Transport& transport, const Settings& settings, std::string first_joint,
        std::shared_ptr<const JointInbox> joints, std::shared_ptr<const WorldInbox> world,
        std::shared_ptr<Notices> notices);

  void look();

  // Whether a sensor that is in the robot's description was ever heard, a while after the beginning.
  template <class State>
  void lookAt(const SensorInbox<State>& sensor) {
    if (sensor.heardNs() == 0) missesSensor(sensor.name(), sensor.topic());
  }

 private:
  void missesSensor(const std::string& name, const std::string& topic);
  void silent(std::int64_t now_ns);

  const Transport* transport_;
  const Settings* settings_;
  std::string first_joint_;
  std::shared_ptr<const JointInbox> joints_;
  std::shared_ptr<const WorldInbox> world_;
  std::shared_ptr<Notices> notices_;
  std::int64_t begun_ns_;
};

}  // namespace robotui::rt::hal::gazebo
