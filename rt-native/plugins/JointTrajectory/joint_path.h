// Points of some joints in the order of their times, and the smooth way through them. All memory is asked for when it
// is made: nothing else allocates, throws or blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace robotui::rt::plugins {

// Where a joint is, rad or m, and its derivatives by time.
struct Knot {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
};

// What points say beyond positions: the way between them is a cubic, or a quintic where all have accelerations. Without
// velocities those are chosen with which no joint goes beyond its points.
enum class Given : std::uint8_t { kPositions, kVelocities, kAccelerations };

// Of a joint, and how much a way wants of it.
struct Bounds {
  double lower;
  double upper;
  double velocity;
};

class JointPath {
 public:
  static constexpr std::size_t kMostPoints = 500;

  explicit JointPath(std::size_t most_joints);

  void clear() noexcept;

  // By index in the robot. False where there is no room, or it is there already.
  bool addJoint(std::size_t joint) noexcept;

  // Seconds from the start of the way; false where there is no room. Its knots are then to be set, by place in
  // joints().
  bool addPoint(double time) noexcept;
  // The only one, of the joints that are there, on a cubic.
  void addPointAlone(double time) noexcept;
  Knot& knot(std::size_t point, std::size_t place) noexcept { return knots_[(point + 1) * most_joints_ + place]; }
  double time(std::size_t point) const noexcept { return times_[point + 1]; }

  // All points are there. `given` is what every one of them says; times are stretched by `stretch`, at least 1.
  void complete(Given given) noexcept;
  void stretch(double factor) noexcept;

  // Where it begins at the time zero; places as in joints().
  Knot& start(std::size_t place) noexcept { return knots_[place]; }

  std::span<const std::size_t> joints() const noexcept { return joints_; }
  std::size_t points() const noexcept { return points_; }
  double duration() const noexcept { return points_ == 0 ? 0 : times_[points_]; }

  Knot at(double time, std::size_t place) const noexcept;

  // What the joint needs between a point and the one before it, which is the start for the first: its fastest velocity
  // as a fraction of the limit, and whether it leaves its range.
  struct Need {
    double velocity;
    bool leaves;
  };
  Need need(std::size_t point, std::size_t place, const Bounds& bounds) const noexcept;

 private:
  const Knot& knotOf(std::size_t index, std::size_t place) const noexcept {
    return knots_[index * most_joints_ + place];
  }
  Knot between(std::size_t index, double time, std::size_t place) const noexcept;
  void chooseVelocities(std::size_t place) noexcept;

  std::size_t most_joints_;
  std::vector<std::size_t> joints_;
  std::vector<double> times_;  // of the start, and then of the points
  std::vector<Knot> knots_;    // likewise, by place
  std::size_t points_ = 0;
  bool is_quintic_ = false;
};

}  // namespace robotui::rt::plugins
