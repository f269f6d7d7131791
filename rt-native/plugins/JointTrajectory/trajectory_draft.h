// A trajectory that is being told, point by point, and checked bit by bit: nothing here takes longer than a cycle may.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "joint_path.h"
#include "robotui/rt/link/fixed_text.h"
#include "robotui/rt/robot/xbot_interface.h"

namespace robotui::rt::plugins {

// Of one joint.
struct Tolerance {
  double path;  // rad or m that it may be away from the way; 0 is any
  double goal;  // likewise at its end
};

struct Tolerances {
  Tolerance joint;
  double goal_time;  // s that joints have to come as near as their goal tolerances
};

class TrajectoryDraft {
 public:
  // Both live as long as the draft.
  TrajectoryDraft(std::span<Joint* const> joints, const Tolerances& defaults);

  void begin() noexcept;
  bool isOpen() const noexcept { return is_open_; }

  // Each is false after it said in why() what is wrong.
  bool addJoint(std::string_view name) noexcept;
  bool addPoint(double seconds) noexcept;
  // Of the last point, the next joints in their order.
  bool addValues(Given kind, std::span<const double> values) noexcept;
  // `factor` of the trajectory's own time, above 0 and up to 1.
  bool setSpeed(double factor) noexcept;
  // At most this fraction of the velocity limits, above 0 and up to 1: it takes longer where it would be faster.
  bool setVelocity(double fraction) noexcept;
  // Of the joints that are named; of all where none is.
  bool allow(double Tolerance::*which, double tolerance, std::string_view names) noexcept;
  bool setGoalTime(double seconds) noexcept;
  // All has been said.
  bool end() noexcept;

  enum class Checked : std::uint8_t { kGoesOn, kGood, kRefused };

  // A point of it, in each call one.
  Checked check() noexcept;
  // The way to the first point, whose start is known now.
  bool checkStart() noexcept;

  JointPath& path() noexcept { return path_; }
  // By place in the joints of the path.
  std::vector<Tolerance>& tolerances() noexcept { return tolerances_; }
  double goalTime() const noexcept { return goal_time_; }
  std::string_view why() const noexcept { return why_.view(); }

  // "not this": for the user.
  template <typename... Parts>
  bool refuse(const Parts&... parts) noexcept {
    why_.assign({});
    (add(parts), ...);
    is_open_ = false;
    return false;
  }

 private:
  void add(std::string_view text) noexcept { why_.append(text); }
  void add(const char* text) noexcept { why_.append(text); }
  void add(double number) noexcept;
  void add(std::size_t number) noexcept;
  bool endPoint() noexcept;
  std::size_t placeOf(std::string_view name) const noexcept;
  bool isWithinLimits(std::size_t place, double position) noexcept;
  bool isBearable(std::size_t point, double most) noexcept;
  std::string_view name(std::size_t place) const noexcept;
  Bounds bounds(std::size_t place) const noexcept;

  std::span<Joint* const> robot_;
  const Tolerances& defaults_;
  std::vector<Tolerance> tolerances_;
  double goal_time_ = 0;
  JointPath path_;
  double speed_ = 1;
  double velocity_ = 0;
  Given given_ = Given::kPositions;
  std::array<std::size_t, 3> said_{};  // values of the last point, by kind
  std::size_t checked_ = 0;
  double fastest_ = 0;  // of the velocity limits
  bool is_open_ = false;
  link::FixedText<400> why_;
};

}  // namespace robotui::rt::plugins
