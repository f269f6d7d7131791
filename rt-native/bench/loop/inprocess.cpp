// rt_inprocess CONFIG WARM SECONDS: the HAL's loop with all plugins of the configuration in its own thread, for so
// long; prints one line of JSON.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

#include <sys/resource.h>

#include "command_plan.h"
#include "loop.h"
#include "plugins_inside.h"
#include "report.h"
#include "robotui/rt/hal/kinds.h"
#include "robotui/rt/link/relaxed.h"
#include "safe_torque.h"

namespace {

using namespace robotui::rt;

class InProcess {
 public:
  explicit InProcess(const std::filesystem::path& file)
      : config_(config::load(file, {})), plan_(config::plan(config_, {.enabled = false})) {
    environment_ = {robot_, config_.model_type,        host::pluginFolders(file), &directory_, master_.get(),
                    &log_,  host::PluginKind::kControl};
    inbox_.offer(0, hal::CommandInbox::HostView::open(host_.shareReadOnly()));
    hardware_.open(*robot_, config_.hal, period());
    hardware_.run(load());
  }

  std::string measure(std::chrono::duration<double> warm, std::chrono::duration<double> time) {
    loop_.start();
    std::this_thread::sleep_for(warm);
    const auto early = link::relaxedCopy(state_->loop);
    const auto early_answers = link::relaxedCopy(hardware_.answers());
    std::this_thread::sleep_for(time);
    const auto late = link::relaxedCopy(state_->loop);
    const auto late_answers = link::relaxedCopy(hardware_.answers());
    loop_.stop();
    return "{" + bench::members(late, early) + ", \"answers\": " + bench::json(late_answers, early_answers) + "}";
  }

 private:
  std::int64_t period() const { return std::chrono::nanoseconds(config_.hal.period).count(); }
  std::uint32_t joints() const { return static_cast<std::uint32_t>(robot_->joints.size()); }

  bench::Plugins load() {
    bench::Plugins plugins;
    link::BoardWriter board(*board_);
    for (std::uint32_t i = 0; i < plan_.plugins.size(); ++i) {
      auto plugin = std::make_unique<host::HostedPlugin>(
          i, plan_.plugins[i].plugin, static_cast<double>(period()) * 1e-9, environment_, hardware_.frame());
      for (std::uint32_t j = 0; j < joints(); ++j) {
        const auto& claims = plugin->claims();
        if (std::find(claims.begin(), claims.end(), robot_->joints[j].name) != claims.end())
          board.grant(j, static_cast<std::uint16_t>(i));
      }
      plugin->want(true);
      plugins.push_back(std::move(plugin));
    }
    return plugins;
  }

  const config::RtConfig config_;
  const config::Plan plan_;
  const std::shared_ptr<const config::RobotDescription> robot_ =
      std::make_shared<config::RobotDescription>(config_.robot);
  link::Segment<link::StateSegment> state_ = link::Segment<link::StateSegment>::create(1);
  link::Segment<link::BoardSegment> board_ = link::Segment<link::BoardSegment>::create(1);
  link::Segment<link::HostSegment> host_ = link::Segment<link::HostSegment>::create(1);
  link::Segment<link::MasterSegment> master_ = link::Segment<link::MasterSegment>::create(1);
  std::unique_ptr<ChannelSegment> channels_ = std::make_unique<ChannelSegment>();
  ChannelDirectory directory_{*channels_, {channels_.get()}};
  LogQueue log_;
  host::PluginEnvironment environment_;
  hal::Waiting waiting_;
  hal::CommandInbox inbox_{hal::commandPlan(plan_, config_.hal.period), joints(),
                           static_cast<std::uint32_t>(config_.hal.misses_before_safe), waiting_};
  hal::NoTorque torque_;
  bench::PluginsInside hardware_{hal::create(config_.hal), *board_, *host_, joints()};
  hal::Cycle cycle_{
      *robot_, {.period_ns = period(), .deadline = config_.hal.deadline}, hardware_, *board_, inbox_, torque_, *state_};
  hal::Loop loop_{cycle_, {.period_ns = period(), .priority = config_.hal.priority, .core = config_.hal.core}};
};

// As in robotui-rt-hal: a loop that computes without a pause is ended by the kernel.
void limitProcessor() {
  const rlimit limit{500'000, 1'000'000};
  ::setrlimit(RLIMIT_RTTIME, &limit);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "rt_inprocess CONFIG WARM SECONDS\n";
    return 2;
  }
  try {
    limitProcessor();
    InProcess process(argv[1]);
    std::cout << process.measure(std::chrono::duration<double>(std::atof(argv[2])),
                                 std::chrono::duration<double>(std::atof(argv[3])))
              << std::endl;
    return 0;
  } catch (const std::exception& e) {
    std::cout << "error " << e.what() << std::endl;
    return 1;
  }
}
