#include "robotui/rt/supervisor/supervisor.h"

#include <poll.h>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/supervisor/shutdown.h"

namespace robotui::rt::supervisor {
namespace {

constexpr int kTurnMs = 20;
constexpr std::int64_t kHostPatience = 3 * link::kSecond;
constexpr std::int64_t kHalPatience = 5 * link::kSecond;

}  // namespace

Supervisor::Supervisor(const Options& options, const config::RtConfig& config, const config::Plan& plan, bool real_time,
                       ControlServer& server, LogFile& log)
    : server_(server), log_(log), board_(config, plan, real_time), registry_(config, plan, board_),
      master_(static_cast<std::uint32_t>(config.robot.joints.size()), config.master),
      ros_process_(config.master == "ROS" && options.communication.enabled), replies_(board_, server),
      pending_([this](std::uint64_t client, const std::string& text) { replies_.reply(client, text); }),
      stops_(config.hal, log), pushes_(config.robot, hal_process_, replies_, log), events_(registry_, pending_, log),
      hosts_(options, plan, {hal_process_, board_, master_, ros_process_}, events_, replies_, log),
      groups_(config, plan, registry_, hal_process_, hosts_, board_, stops_, replies_, log),
      joint_events_(config, plan, registry_, hosts_, pending_, stops_, log),
      hal_(options, config, hal_process_, board_, hosts_, joint_events_, stops_, pushes_, groups_, replies_, log),
      ros_(options, ros_process_, hosts_, log),
      plugin_requests_(registry_, hosts_, pending_, board_, stops_, groups_, replies_),
      robot_requests_(config.robot, hal_process_, hosts_, board_, stops_, replies_),
      master_requests_(master_, registry_, options.communication.enabled, replies_, log),
      requests_(plugin_requests_, robot_requests_, master_requests_, pushes_, groups_, replies_, log) {}

// Whatever goes wrong here, the HAL is told to end: it must not be killed with the robot in motion.
int Supervisor::run() {
  if (const std::string lack = ros_process_.lack(); !lack.empty()) {
    log_.warn(lack);
  }
  try {
    hal_.spawn();
    while (!ending_) {
      waitForSomething();
      turn();
    }
  } catch (const std::exception& e) {
    log_.error(std::string("robotui-rt cannot go on: ") + e.what());
    exit_code_ = 1;
  }
  end();
  return exit_code_;
}

void Supervisor::waitForSomething() {
  std::vector<pollfd> polled{{signals_.get(), POLLIN, 0}};
  std::vector<Child*> children = hosts_.running();
  children.insert(children.end(), {&hal_process_.child(), &ros_process_.child()});
  for (Child* child : children) {
    if (child->isAlive()) {
      polled.push_back({child->socket().get(), POLLIN, 0});
    }
  }
  if (serving_) {
    server_.addTo(polled);
  }
  ::poll(polled.data(), polled.size(), kTurnMs);
}

void Supervisor::turn() {
  ending_ = signals_.take() || ending_;
  if (!hal_.turn(serving_)) {
    exit_code_ = 1;
    ending_ = true;
  }
  hosts_.turn();
  serving_ = serving_ || hosts_.areSettled();
  const std::int64_t now = link::now();
  joint_events_.turn(now);
  groups_.turn();
  for (const auto& [client, words] : groups_.takeDeferred()) plugin_requests_.switchPlugin(client, words);
  if (!ending_) {
    hal_.respawn(now);
    hosts_.respawn(now);
  }
  hal_.watch(now);
  hosts_.watch(now);
  if (!ending_) {
    ros_.turn(now, serving_);
  }
  serveClients(now);
  board_.publish();
}

void Supervisor::serveClients(std::int64_t now_ns) {
  if (serving_) {
    server_.serve([this](std::uint64_t client, const link::Packet& packet) { requests_.serve(client, packet); },
                  [this](std::uint64_t client) {
                    master_.forget(client);
                    pending_.forget(client);
                    pushes_.forget(client);
                  });
  }
  pending_.expire(now_ns);
  if (master_.expire(now_ns)) {
    log_.warn("The master sent no references any more: it is none now.");
  }
}

// First the plugins, while the HAL still holds the robot; then the HAL, which makes it safe before it goes.
void Supervisor::end() {
  log_.info("robotui-rt ends.");
  std::vector<Child*> clients_of_hal = hosts_.running();
  if (ros_process_.child().isAlive()) {
    clients_of_hal.push_back(&ros_process_.child());
  }
  endProcesses(clients_of_hal, kHostPatience, signals_);
  if (hal_process_.child().isAlive()) {
    endProcesses({&hal_process_.child()}, kHalPatience, signals_);
  }
}

}  // namespace robotui::rt::supervisor
