// robotui-rt-ros: the robot in ROS. Started by robotui-rt, or by hand beside it.
#include <getopt.h>
#include <sys/resource.h>

#include <charconv>
#include <csignal>
#include <cstring>
#include <iostream>

#include "follow_trajectory.h"
#include "robot_topics.h"
#include "master_watch.h"
#include "plugin_ports.h"
#include "robotui/rt/link/clock.h"
#include "supervision.h"

namespace {

namespace config = robotui::rt::config;
namespace link = robotui::rt::link;
using namespace robotui::rt::ros_bridge;
using robotui::rt::ChannelDirectory;
using robotui::rt::ChannelSegment;

constexpr std::uint32_t kServiceThreads = 4;
constexpr rlim_t kMostMemory = rlim_t{4} << 30;  // ROS believes the length that a message says of itself
constexpr std::int64_t kPortsEvery = 2 * link::kMillisecond;

volatile std::sig_atomic_t ending = 0;

struct Options {
  std::string config;
  std::string name;
  config::Overrides overrides;
  config::Communication communication;
  int control = -1;
};

std::chrono::microseconds microseconds(const char* text) {
  long long us = 0;
  const char* end = text + std::strlen(text);
  if (std::from_chars(text, end, us).ec != std::errc() || us < 100 || us > 1'000'000)
    throw std::runtime_error("A period is from 100 to 1000000 microseconds.");
  return std::chrono::microseconds(us);
}

Options parse(int argc, char** argv) {
  static constexpr option kKnown[] = {
      {"config", required_argument, nullptr, 'C'},  {"dummy", no_argument, nullptr, 'D'},
      {"period", required_argument, nullptr, 'p'},  {"ch-period", required_argument, nullptr, 'c'},
      {"no-ch", no_argument, nullptr, 'n'},         {"name", required_argument, nullptr, 'N'},
      {"control", required_argument, nullptr, 'f'}, {nullptr, 0, nullptr, 0}};
  Options options;
  for (int key = 0; (key = getopt_long(argc, argv, "C:D", kKnown, nullptr)) != -1;) {
    switch (key) {
      case 'C': options.config = optarg; break;
      case 'D': options.overrides.dummy = true; break;
      case 'p': options.overrides.period = microseconds(optarg); break;
      case 'c': options.communication.period = microseconds(optarg); break;
      case 'n': options.communication.enabled = false; break;
      case 'N': options.name = optarg; break;
      case 'f': options.control = static_cast<int>(std::strtol(optarg, nullptr, 10)); break;
      default:
        throw std::runtime_error("usage: robotui-rt-ros -C CONFIG [-D] [--period US] [--ch-period US] [--name NAME]");
    }
  }
  if (options.config.empty()) throw std::runtime_error("A configuration is needed: robotui-rt-ros -C FILE.");
  return options;
}

void limitMemory() {
  const rlimit limit{kMostMemory, kMostMemory};
  ::setrlimit(RLIMIT_AS, &limit);
}

void sleepUntil(std::int64_t at_ns) {
  const timespec at = link::toTimespec(at_ns);
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr);
}

// False where the end came first.
bool awaitMaster(Supervision& supervision) {
  if (ros::master::check()) return true;
  supervision.say("info", "ROS: waiting for the master at " + ros::master::getURI() + ".");
  while (!ros::master::check()) {
    if (ending != 0 || !supervision.goesOn()) return false;
    sleepUntil(link::now() + link::kSecond / 2);
  }
  return true;
}

class BridgeProcess {
 public:
  BridgeProcess(const Options& options, Supervision& supervision)
      : config_(config::load(options.config, options.overrides)), plan_(config::plan(config_, options.communication)),
        transforms_(config_.robot), supervision_(supervision),
        period_ns_(std::chrono::nanoseconds(options.communication.period).count()),
        name_(options.name.empty() ? config_.robot.name : options.name), robot_(name_, config_.robot.joints.size()),
        requests_(name_), channels_(channelsOf(supervision)), spinner_(kServiceThreads, &services_) {}

  void run() {
    spinner_.start();
    MasterWatch watch;
    offer();
    std::int64_t next = link::now();
    for (std::int64_t publish_at = next; ending == 0 && ros::ok() && supervision_.goesOn();) {
      if (watch.takeForgotten()) offer();
      robot_.keep();
      ros::getGlobalCallbackQueue()->callAvailable();
      ports_->turn();
      if (link::now() >= publish_at) {
        topics_->publish();
        publish_at = std::max(publish_at + period_ns_, link::now());
      }
      next = std::max(next + std::min(period_ns_, kPortsEvery), link::now());
      sleepUntil(next);
    }
    spinner_.stop();
  }

 private:
  // Says all to the master, also again.
  void offer() {
    const LogFunction log = [this](const char* level, const std::string& line) {
      supervision_.say(level, "ROS: " + line);
    };
    actions_.clear();
    ports_.reset();
    topics_.reset();
    topics_ = std::make_unique<RobotTopics>(config_, plan_, transforms_, robot_, requests_, services_, log);
    ports_ = std::make_unique<PluginPorts>(channels_.get(), plan_, services_, log);
    offerActions(log);
    log("info", "registered with the master at " + ros::master::getURI() + ".");
  }

  // One whose trajectory is followed goes on: only its client does not hear of it any more.
  void offerActions(const LogFunction& log) {
    std::vector<std::string> joints;
    for (const auto& joint : config_.robot.joints) joints.push_back(joint.name);
    for (const auto& each : plan_.plugins) {
      if (channels_ == nullptr || each.plugin.type != "JointTrajectory") continue;
      actions_.push_back(std::make_unique<FollowTrajectory>(each.plugin.name, name_, joints, *channels_, log));
    }
  }

  static std::unique_ptr<ChannelDirectory> channelsOf(const Supervision& supervision) {
    if (supervision.own() == nullptr) return nullptr;
    std::vector<const ChannelSegment*> all = supervision.hosts();
    all.push_back(supervision.own());
    return std::make_unique<ChannelDirectory>(*supervision.own(), std::move(all));
  }

  config::RtConfig config_;
  config::Plan plan_;
  Transforms transforms_;
  Supervision& supervision_;
  std::int64_t period_ns_;
  std::string name_;
  Robot robot_;
  Requests requests_;
  std::unique_ptr<ChannelDirectory> channels_;
  ros::CallbackQueue services_;
  ros::AsyncSpinner spinner_;
  std::unique_ptr<RobotTopics> topics_;
  std::unique_ptr<PluginPorts> ports_;
  std::vector<std::unique_ptr<FollowTrajectory>> actions_;
};

int work(int argc, char** argv) {
  const Options options = parse(argc, argv);
  Supervision supervision(options.control);
  limitMemory();
  ros::M_string remappings;
  ros::init(remappings, "xbotcore", ros::init_options::NoSigintHandler);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { ending = 1; });
  ros::master::setRetryTimeout(ros::WallDuration(2));
  if (!awaitMaster(supervision)) return 0;
  ros::start();
  try {
    BridgeProcess(options, supervision).run();
  } catch (const std::exception& e) {
    supervision.say("error", std::string("ROS: ") + e.what());
    ros::shutdown();
    return 1;
  }
  ros::shutdown();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return work(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "robotui-rt-ros: " << e.what() << "\n";
    return 1;
  }
}
