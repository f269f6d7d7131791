#include "process.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

#include "robotui/rt/hal/kinds.h"
#include "robotui/rt/link/words.h"

namespace robotui::rt::hal {

namespace {

constexpr std::chrono::milliseconds kLook{20};  // what there is to tell comes no later

std::uint32_t generationOf(const link::BoardSegment& board) {
  auto data = std::make_unique<link::BoardData>();
  link::BoardReader(board).read(*data);
  return data->hal_respawns + 1;
}

constexpr std::array kPhases{"disabled", "enabling", "enabled", "fault", "silent"};  // by DrivePhase

// A line each: phase, joint, detail.
std::string textOf(const std::vector<DriveReport>& drives) {
  std::string text;
  for (const DriveReport& drive : drives) {
    text += text.empty() ? "" : "\n";
    text.append(kPhases[static_cast<std::size_t>(drive.phase)]) += "\t" + drive.joint + "\t" + drive.detail;
  }
  return text;
}

// A robot without a model that can be computed still has damping: better than none that moves.
std::unique_ptr<SafeTorque> torqueOf(const config::RtConfig& config, std::vector<std::string>& warnings) {
  if (config.hal.safe_law == config::SafeLaw::kDamping) return std::make_unique<NoTorque>();
  try {
    return makeGravityTorque(std::make_shared<config::RobotDescription>(config.robot), config.model_type);
  } catch (const std::runtime_error& error) {
    warnings.push_back(std::string("The safe law is damping instead of gravity: ") + error.what());
    return std::make_unique<NoTorque>();
  }
}

CycleSettings cycleSettings(const config::HalConfig& hal) {
  return {.period_ns = std::chrono::nanoseconds(hal.period).count(),
          .deadline = hal.deadline,
          .safe_damping = hal.safe_damping,
          .misses_before_safe = static_cast<std::uint32_t>(hal.misses_before_safe),
          .following_errors = hal.following_errors,
          .following_cycles = std::max<std::uint64_t>(
              1, static_cast<std::uint64_t>(hal.following_time * 1e6 / static_cast<double>(hal.period.count()))),
          .emergency_stops = hal.emergency_stops.size()};
}

}  // namespace

Process::Process(const ProcessOptions& options, link::Packet begin) {
  if (begin.descriptors.empty()) throw std::runtime_error("The supervisor gave no board.");
  const config::RtConfig config = config::load(options.config, options.overrides);
  board_ = link::Segment<const link::BoardSegment>::open(std::move(begin.descriptors.front()));
  const CycleSettings settings = cycleSettings(config.hal);
  inbox_ = std::make_unique<CommandInbox>(
      commandPlan(config::plan(config, options.communication), std::chrono::nanoseconds(settings.period_ns)),
      static_cast<std::uint32_t>(config.robot.joints.size()), settings.misses_before_safe, waiting_);
  hosts(begin);
  torque_ = torqueOf(config, warnings_);
  hal_ = create(config.hal);
  hal_->open(config.robot, config.hal, settings.period_ns);
  state_ = link::Segment<link::StateSegment>::create(generationOf(*board_));
  state_.sealAgainstWriters();
  cycle_ = std::make_unique<Cycle>(config.robot, settings, *hal_, *board_, *inbox_, *torque_, *state_);
  loop_ = std::make_unique<Loop>(*cycle_, LoopSettings{.period_ns = settings.period_ns,
                                                       .priority = options.nrt ? 0 : config.hal.priority,
                                                       .runtime = config.hal.runtime,
                                                       .core = config.hal.core,
                                                       .allow_non_rt = options.allow_non_rt});
  for (std::string& refusal : loop_->start()) warnings_.push_back(std::move(refusal));
  if (cycle_->statistics().priority > 0) stayAwake(config.hal.wake_latency_us);
}

void Process::stayAwake(int most_us) {
  wake_latency_ = std::make_unique<WakeLatency>(most_us);
  if (wake_latency_->refusal()) warnings_.push_back(*wake_latency_->refusal());
}

Process::~Process() {
  loop_.reset();
  if (hal_) hal_->close();
}

void Process::hosts(link::Packet& begin) {
  for (std::size_t i = 1; i < begin.descriptors.size(); ++i) {
    inbox_->offer(static_cast<std::uint32_t>(i - 1),
                  CommandInbox::HostView::openAsItIs(std::move(begin.descriptors[i])));
  }
}

bool Process::replaceHost(link::Packet& packet) {
  std::uint32_t host = link::kMaxHosts;
  const std::string_view index = packet.rest();
  std::from_chars(index.data(), index.data() + index.size(), host);
  if (host >= link::kMaxHosts || packet.descriptors.empty()) return false;
  inbox_->offer(host, CommandInbox::HostView::openAsItIs(std::move(packet.descriptors.front())));
  return true;
}

void Process::tellDrives(const link::Socket& supervisor) {
  std::string now = textOf(hal_->drives());
  if (now == told_drives_) return;
  told_drives_ = std::move(now);
  supervisor.send("drives " + told_drives_);
}

void Process::tellStops(const link::Socket& supervisor) {
  const StopReport now = cycle_->takeStops();
  if (now.bits == told_stops_) return;
  told_stops_ = now.bits;
  supervisor.send("stops " + std::to_string(now.bits.pressed) + " " + std::to_string(now.bits.unread) + " " +
                  std::to_string(now.cycle));
}

void Process::press(std::string_view words, const link::Socket& supervisor) {
  const auto [index, wanted] = link::splitWord(words);
  std::size_t stop = link::kMaxStops;
  std::from_chars(index.data(), index.data() + index.size(), stop);
  if (!hal_->press(stop, wanted == "1"))
    supervisor.send("log warn The emergency stops of this HAL are real: press and release them by hand.");
}

// The supervisor orders one at a time: there is room.
void Process::switchGroup(const link::Packet& packet) {
  if (packet.verb() == "cancel") {
    std::uint32_t group = 0;
    std::from_chars(packet.rest().data(), packet.rest().data() + packet.rest().size(), group);
    cycle_->groups().cancel(group);
  } else if (const auto order = link::groupOrderOf(packet.rest())) {
    cycle_->groups().order(*order);
  }
}

void Process::push(std::string_view words, const link::Socket& supervisor) {
  const auto push = link::pushOf(words);
  const auto [number, rest] = link::splitWord(words);
  const std::string objection = push ? hal_->push(*push) : "The HAL does not understand this push.";
  supervisor.send("pushed " + std::string(number) + (objection.empty() ? "" : " " + objection));
}

void Process::obey(const link::Socket& supervisor, const std::atomic<bool>& ended) {
  link::Packet packet;
  while (!ended) {
    const link::Received received = supervisor.receive(packet, kLook);
    for (const std::string& sentence : hal_->news()) supervisor.send("log warn " + sentence);
    tellStops(supervisor);
    for (link::GroupOutcome outcome; cycle_->groups().take(outcome);) supervisor.send(link::textOf(outcome));
    for (link::JointEvent event; cycle_->takeEvent(event);) supervisor.send(link::textOf(event));
    tellDrives(supervisor);
    if (received == link::Received::kTimeout) continue;
    if (received == link::Received::kClosed || packet.verb() == "end") break;
    if (packet.verb() == "recover" || packet.verb() == "enable" || packet.verb() == "disable") {
      const bool recovers = packet.verb() == "recover";
      for (const std::string& sentence : recovers ? hal_->recover() : hal_->enable(packet.verb() == "enable"))
        supervisor.send("log info " + sentence);
    } else if (packet.verb() == "press") {
      press(packet.rest(), supervisor);
    } else if (packet.verb() == "group" || packet.verb() == "cancel") {
      switchGroup(packet);
    } else if (packet.verb() == "push") {
      push(packet.rest(), supervisor);
    } else if (packet.verb() != "host" || !replaceHost(packet)) {
      supervisor.send("log warn The HAL does not understand '" + packet.text + "'.");
    }
  }
  loop_->stop();
}

}  // namespace robotui::rt::hal
