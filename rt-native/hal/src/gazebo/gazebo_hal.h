// A robot in a Gazebo world: joints and sensors by the Gazebo transport, in the time of the simulator.
#pragma once

#include <memory>
#include <vector>

#include "../simulated_stops.h"
#include "robotui/rt/hal/hal.h"
#include "sender.h"
#include "watch.h"

namespace robotui::rt::hal::gazebo {

// The thread of real time exchanges values alone with those of the transport. It is told kTimeout while simulated time
// stands or nothing comes, and for some cycles after that time went back: then all joints become safe.
class GazeboHal final : public Hal {
 public:
  ~GazeboHal() override { GazeboHal::close(); }

  void open(const config::RobotDescription& robot, const config::HalConfig& config, std::int64_t period_ns) override;
  Status sense(Measurements& into) noexcept override;
  Status move(std::span<const Reference> references) noexcept override;
  void senseStops(std::span<StopInput> into) noexcept override { stops_.sense(into); }
  void close() noexcept override;
  bool press(std::size_t stop, bool pressed) override { return stops_.press(stop, pressed); }
  std::string push(const link::Push& /*push*/) override {
    return "The forces of this simulation are Gazebo's: push the robot there, by its panel 'Apply force and torque'.";
  }
  std::vector<std::string> news() override;

  std::uint64_t dropped() const noexcept { return joints_ ? joints_->dropped() : 0; }

 private:
  void subscribe(const config::RobotDescription& robot);
  void awaitState(const std::string& first_joint);
  void measure(Measurements& into) noexcept;
  Status status(Measurements& into) noexcept;
  void end();

  Settings settings_;
  SimulatedStops stops_;
  std::shared_ptr<Notices> notices_;
  std::shared_ptr<JointInbox> joints_;
  std::shared_ptr<WorldInbox> world_;
  std::vector<std::shared_ptr<SensorInbox<link::ImuState>>> imus_;
  std::vector<std::shared_ptr<SensorInbox<link::ForceTorqueState>>> force_torques_;
  std::unique_ptr<Transport> transport_;
  std::unique_ptr<Sender> sender_;
  std::unique_ptr<Watch> watch_;
  Sample sample_{};
  std::uint64_t last_sample_ = 0;
  std::uint64_t era_ = 0;
  int cycles_after_reset_ = 0;
  int resting_ = 0;  // cycles that remain of them
  Status status_ = Status::kTimeout;
};

}  // namespace robotui::rt::hal::gazebo
