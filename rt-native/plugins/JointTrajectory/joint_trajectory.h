// Takes joints along points in time: those of a file (robotui-rt-ctl trajectory), or of words that say the same.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robotui/rt/plugin/control_plugin.h"
#include "robotui/rt/plugin/trajectory_report.h"
#include "trajectory_draft.h"

namespace robotui::rt::plugins {

enum class TrajectoryState : std::uint8_t {
  kHolding,
  kReading,
  kChecking,
  kMoving,
  kSettling,
  kDone,
  kRefused,
  kAborted,
  kStopped
};

// Parameters: `joints` or `chains` (all), `path_tolerance` and `goal_tolerance` (rad or m; 0.2 and 0.02, 0 is any),
// `goal_time` (s that joints have to come within the goal tolerance, 1).
//
// Words of a trajectory, in this order: `begin`; `joints NAME...` (again for more); for each point `point SECONDS`,
// `positions NUMBER...`, and where they are given `velocities`, `accelerations` (again for more joints); then where
// they are wanted `path TOLERANCE`, `goal TOLERANCE` (of all joints, or of those that are named behind it), `patience
// SECONDS`, `speed FACTOR`, `velocity FRACTION`; and `run`. `stop` ends one. Several may be said at once, with `;`
// between them. A new one takes over from where the old one has come, in place and velocity.
//
// Who puts a tag before them (`@17 begin`, `@17 joints elbow`, a number above 0) finds it again in the channel that
// says how it goes (TrajectoryReport), and is not taken for another client that tells one at the same time; `@17 stop`
// ends that one alone.
class JointTrajectory : public ControlPlugin {
 public:
  bool init_control_plugin(Setup& setup) override;
  RtStatus on_start(double time) override;
  RtStatus control_loop(double time, double period) override;
  void on_stop(double time) override;
  bool on_command(std::string_view words) override;
  std::string_view status() const noexcept override { return status_.view(); }

 protected:
  TrajectoryDraft& draft() noexcept { return *draft_; }
  // The draft is complete: it is checked in the next cycles, and then moved along. False after why() said what is
  // wrong.
  bool run() noexcept;
  void stop() noexcept;

  TrajectoryPhase phase() const noexcept { return report_.phase; }  // of what it follows, or followed last
  std::string_view why() const noexcept { return why_.view(); }
  const JointPath& path() const noexcept { return *path_; }  // along which it moves, or moved last
  const Joint& joint(std::size_t index) const noexcept { return *joints_[index]; }
  const Knot& reference(std::size_t index) const noexcept { return references_[index]; }
  double seconds() const noexcept { return now_ - begun_; }  // on that path

 private:
  bool obey(std::uint64_t tag, std::string_view words) noexcept;
  bool begin(std::uint64_t tag) noexcept;
  bool stop(std::uint64_t tag) noexcept;
  bool order(std::string_view verb, std::string_view words) noexcept;
  bool addNames(std::string_view words) noexcept;
  bool addNumbers(Given kind, std::string_view words) noexcept;
  bool object(std::string_view why) noexcept;
  bool refuse(std::string_view why, TrajectoryPhase phase = TrajectoryPhase::kRefused) noexcept;
  void check() noexcept;
  void launch() noexcept;
  bool takesOver(const JointPath& next) noexcept;
  void move() noexcept;
  void settle() noexcept;
  const Joint* astray(double Tolerance::*which, double& away) const noexcept;
  void abort(const Joint& joint, double away, TrajectoryPhase why) noexcept;
  void giveUp() noexcept;
  void report() noexcept;
  void comeToRest() noexcept;
  void enter(TrajectoryState state) noexcept;

  std::vector<Joint*> joints_;
  std::vector<Knot> references_;  // by place in joints_
  Tolerances defaults_{{0.2, 0.02}, 1};
  std::vector<Tolerance> tolerances_;  // of path_, by place
  double goal_time_ = 0;
  std::unique_ptr<TrajectoryDraft> draft_;
  std::unique_ptr<JointPath> path_;
  bool moves_ = false;  // along path_
  TrajectoryState state_ = TrajectoryState::kHolding;
  TrajectoryState after_ = TrajectoryState::kDone;  // what it is once it has come to the end of path_
  double now_ = 0;
  double before_ = 0;  // of the last cycle
  double begun_ = 0;
  bool runs_ = false;
  link::FixedText<400> why_;
  link::FixedText<480> status_;
  TrajectoryReport report_{};
  ChannelWriter<TrajectoryReport> reports_;
};

}  // namespace robotui::rt::plugins
