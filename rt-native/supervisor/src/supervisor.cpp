#include "robotui/rt/supervisor/supervisor.h"

#include <poll.h>

#include "robotui/rt/link/clock.h"

namespace robotui::rt::supervisor {
namespace {

constexpr int kTurnMs = 20;
constexpr std::int64_t kHostPatience = 3 * link::kSecond;
constexpr std::int64_t kHalPatience = 5 * link::kSecond;

}  // namespace

Supervisor::Supervisor(const Options& options, const config::RtConfig& config, const config::Plan& plan, bool real_time, Desk& desk,
                       Journal& journal)
    : options_(options), config_(config), plan_(plan), desk_(desk), journal_(journal), board_(config, plan, real_time),
      roster_(config, plan, board_), master_(static_cast<std::uint32_t>(config.robot.joints.size()), config.master),
      pending_([this](std::uint64_t client, const std::string& text) { reply(client, text); }),
      ros_(config.master == "ROS" && options.communication.enabled) {
  for (std::uint32_t i = 0; i < plan.hosts.size(); ++i) {
    hosts_.push_back(std::make_unique<HostKeeper>(i, plan.hosts[i]));
  }
}

// Whatever goes wrong here, the HAL is told to end: it must not be killed with the robot in motion.
int Supervisor::run() {
  if (const std::string lack = ros_.lack(); !lack.empty()) {
    journal_.warn(lack);
  }
  try {
    spawnHal();
    while (!ending_) {
      waitForSomething();
      turn();
    }
  } catch (const std::exception& e) {
    journal_.error(std::string("robotui-rt cannot go on: ") + e.what());
    exit_code_ = 1;
  }
  end();
  return exit_code_;
}

void Supervisor::waitForSomething() {
  std::vector<pollfd> polled{{signals_.get(), POLLIN, 0}};
  if (hal_.child().isAlive()) {
    polled.push_back({hal_.child().socket().get(), POLLIN, 0});
  }
  for (const auto& host : hosts_) {
    if (host->child().isAlive()) {
      polled.push_back({host->child().socket().get(), POLLIN, 0});
    }
  }
  if (ros_.child().isAlive()) {
    polled.push_back({ros_.child().socket().get(), POLLIN, 0});
  }
  if (serving_) {
    desk_.addTo(polled);
  }
  ::poll(polled.data(), polled.size(), kTurnMs);
}

void Supervisor::turn() {
  ending_ = signals_.take() || ending_;
  hearHal();
  reapHal();
  for (std::uint32_t i = 0; i < hosts_.size(); ++i) {
    hearHost(i);
    reapHost(i);
  }
  const std::int64_t now = link::now();
  respawn(now);
  watch(now);
  keepRos(now);
  if (serving_) {
    desk_.serve([this](std::uint64_t client, const link::Packet& packet) { serve(client, packet); },
                [this](std::uint64_t client) {
                  master_.forget(client);
                  pending_.forget(client);
                });
  }
  pending_.expire(now);
  if (master_.expire(now)) {
    journal_.warn("The master sent no references any more: it is none now.");
  }
  board_.publish();
}

// First the plugins, while the HAL still holds the robot; then the HAL, which makes it safe before it goes.
void Supervisor::end() {
  journal_.info("robotui-rt ends.");
  std::vector<Child*> children;
  for (const auto& host : hosts_) {
    if (host->child().isAlive()) {
      host->child().socket().send("end");
      children.push_back(&host->child());
    }
  }
  if (ros_.child().isAlive()) {
    ros_.child().socket().send("end");
    children.push_back(&ros_.child());
  }
  awaitEnd(kHostPatience, children);
  if (hal_.child().isAlive()) {
    hal_.child().socket().send("end");
    awaitEnd(kHalPatience, {&hal_.child()});
  }
}

void Supervisor::awaitEnd(std::int64_t patience_ns, const std::vector<Child*>& children) {
  const std::int64_t until = link::now() + patience_ns;
  for (bool impatient = false; !impatient && link::now() < until;) {
    bool alive = false;
    for (Child* child : children) {
      child->end();
      alive = alive || child->isAlive();
    }
    if (!alive) {
      return;
    }
    pollfd polled{signals_.get(), POLLIN, 0};
    ::poll(&polled, 1, kTurnMs);
    impatient = signals_.take();  // asked to end a second time
  }
  for (Child* child : children) {
    child->kill();
  }
}

}  // namespace robotui::rt::supervisor
