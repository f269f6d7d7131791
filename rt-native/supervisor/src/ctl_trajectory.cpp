#include "ctl_trajectory.h"

#include <chrono>
#include <iostream>
#include <thread>

#include "robotui/rt/config/reader.h"
#include "robotui/rt/link/trajectory_orders.h"

namespace robotui::rt::supervisor {
namespace {

constexpr link::Client::Milliseconds kReply{5000};
constexpr std::chrono::milliseconds kLook{50};
constexpr std::chrono::milliseconds kToSay{500};  // until the status says why something was refused
constexpr double kMost = 1e6;

void addNumbers(link::TrajectoryOrders& orders, const config::Reader& point, const std::string& key) {
  const auto list = point.find(key);
  if (!list) return;
  std::vector<double> numbers;
  for (const auto& item : list->items("[0.5, -0.2]")) numbers.push_back(item.real(-kMost, kMost));
  orders.values(key, numbers);
}

// Seconds, or secs and nsecs as ROS prints them.
double secondsOf(const config::Reader& time) {
  if (!time.node().IsMap()) return time.real(0, kMost);
  time.knowsOnly({"secs", "nsecs"});
  return time.realOr("secs", 0, 0, kMost) + time.realOr("nsecs", 0, 0, 1e9) * 1e-9;
}

void addPoint(link::TrajectoryOrders& orders, const config::Reader& point) {
  point.knowsOnly({"positions", "velocities", "accelerations", "effort", "time_from_start"});
  orders.point(secondsOf(point.at("time_from_start", "time_from_start: 1.5")));
  point.at("positions", "positions: [0.5, -0.2]");
  for (const char* key : {"positions", "velocities", "accelerations"}) addNumbers(orders, point, key);
}

bool isAtAnEnd(const std::string& status) {
  for (const char* end : {"done", "stopped", "refused", "aborted", "holding"}) {
    if (status.starts_with(std::string("running: ") + end) || !status.starts_with("running")) return true;
  }
  return false;
}

std::string statusOf(link::Client& client, const std::string& plugin) {
  return client.request("status " + plugin, kReply).text;
}

// It says why a moment later.
int sayWhyNot(link::Client& client, const std::string& plugin, const std::string& reply) {
  const auto until = std::chrono::steady_clock::now() + kToSay;
  std::string status;
  do {
    status = statusOf(client, plugin);
    if (status.find("refused") == std::string::npos) std::this_thread::sleep_for(kLook);
  } while (status.find("refused") == std::string::npos && std::chrono::steady_clock::now() < until);
  std::cerr << reply << '\n' << plugin << " is " << status << '\n';
  return 1;
}

}  // namespace

std::vector<std::string> trajectoryWords(const std::filesystem::path& file) {
  const auto absolute = std::filesystem::absolute(file);
  const config::Reader top = config::readYamlFile(absolute, {}, "the trajectory");
  top.knowsOnly(
      {"header", "joint_names", "points", "path_tolerance", "goal_tolerance", "goal_time", "speed", "velocity"});
  link::TrajectoryOrders orders;
  std::vector<std::string> names;
  for (const auto& item : top.at("joint_names", "joint_names: [elbow]").items("[elbow]")) names.push_back(item.text());
  orders.joints(names);
  for (const auto& point : top.at("points", "points: [{positions: [0.5], time_from_start: 1}]")
                               .items("[{positions: [0.5], time_from_start: 1}]"))
    addPoint(orders, point);
  const std::pair<const char*, const char*> settings[] = {{"path_tolerance", "path"},
                                                          {"goal_tolerance", "goal"},
                                                          {"goal_time", "patience"},
                                                          {"speed", "speed"},
                                                          {"velocity", "velocity"}};
  for (const auto& [key, verb] : settings) {
    if (const auto value = top.find(key)) orders.say(verb, value->real(0, kMost));
  }
  return orders.take();
}

int runTrajectory(link::Client& client, const std::string& plugin, const std::filesystem::path& file) {
  for (const std::string& order : trajectoryWords(file)) {
    const link::Reply reply = client.request("command " + plugin + " " + order, kReply);
    if (!reply.ok) return sayWhyNot(client, plugin, reply.text);
  }
  std::this_thread::sleep_for(kLook);
  std::string status = statusOf(client, plugin);
  for (std::string said; !isAtAnEnd(status); status = statusOf(client, plugin)) {
    if (status != said) std::cout << plugin << " is " << status << std::endl;
    said = status;
    std::this_thread::sleep_for(kLook);
  }
  const bool is_done = status == "running: done";
  (is_done ? std::cout : std::cerr) << plugin << " is " << status << '\n';
  return is_done ? 0 : 1;
}

}  // namespace robotui::rt::supervisor
