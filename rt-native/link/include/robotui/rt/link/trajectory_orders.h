// The orders by which a client tells the plugin JointTrajectory a trajectory: as few as its words fit into.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace robotui::rt::link {

// In the order that the plugin's header names. What is said is checked by the plugin, not here; names are words without
// `;`.
class TrajectoryOrders {
 public:
  // With a tag of its own, by which it is told from those of other clients.
  TrajectoryOrders();

  std::uint64_t tag() const noexcept { return tag_; }

  void joints(std::span<const std::string> names) { say("joints", names); }
  void point(double seconds) { say("point", seconds); }
  // Of the last point: `positions`, `velocities` or `accelerations`.
  void values(std::string_view kind, std::span<const double> numbers);
  // A setting of the whole trajectory, or of one joint.
  void say(std::string_view verb, double number, std::string_view joint = {});

  // All of them, with `run` at the end.
  std::vector<std::string> take();

  // The order that ends this one, whether it has begun or not.
  std::string stop() const;

 private:
  void say(std::string_view verb, std::span<const std::string> words);
  void add(const std::string& phrase);

  std::uint64_t tag_;
  std::string order_;
  std::vector<std::string> orders_;
};

}  // namespace robotui::rt::link
