#include "robotui/rt/supervisor/joint_events.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "robotui/rt/link/clock.h"
#include "robotui/rt/link/relaxed.h"

namespace robotui::rt::supervisor {
namespace {

using link::FallCause;
using link::JointEvent;
using link::Objection;
using link::PluginState;

// A host says within some milliseconds that a plugin failed.
constexpr std::int64_t kUntilItIsJudged = 50 * link::kMillisecond;
constexpr std::size_t kNamed = 4;                            // joints in a sentence
constexpr std::int64_t kLongestCall = 3600 * link::kSecond;  // what a broken host says beyond that is nothing

std::string milliseconds(std::int64_t ns) {
  std::ostringstream text;
  text << std::setprecision(3) << static_cast<double>(ns) / 1e6 << " ms";
  return text.str();
}

std::string wordsOf(Objection objection) {
  switch (objection) {
    case Objection::kNone: break;
    case Objection::kNotOwner: return "is not its to command";
    case Objection::kUnknownMode: return "has a mode that is not known";
    case Objection::kNoNumber: return "is no number";
    case Objection::kBadGain: return "has a stiffness or a damping that is negative or no number";
  }
  return "cannot be obeyed";
}

std::string upTo(const JointEvent& event) { return ", in cycle " + std::to_string(event.cycle); }

}  // namespace

void JointEvents::handle(std::string_view words, std::int64_t now_ns) {
  const auto event = link::jointEventOf(words);
  if (!event || event->plugin >= registry_.size()) {
    log_.warn("The HAL says of joints what cannot be read: " + std::string(words.substr(0, link::kNameLength)));
  } else if (event->cause != FallCause::kNone) {
    falls_.push_back({*event, now_ns + kUntilItIsJudged});
  } else {
    log_.warn("What the plugin " + registry_.name(event->plugin) + " commands the joint " + joint(event->joint) + " " +
              wordsOf(event->objection) + upTo(*event) + ": it is refused, and the joint holds. So far " +
              std::to_string(event->rejected) + " commands of this joint were refused.");
  }
}

void JointEvents::turn(std::int64_t now_ns) {
  const auto rest =
      std::stable_partition(falls_.begin(), falls_.end(), [&](const Fall& fall) { return fall.due_ns <= now_ns; });
  const std::vector<Fall> due(falls_.begin(), rest);
  falls_.erase(falls_.begin(), rest);
  for (const Fall& fall : due) judge(fall.event);
}

// One of a start before says nothing about this one.
void JointEvents::judge(const JointEvent& event) {
  const std::string& name = registry_.name(event.plugin);
  const std::string start = "robotui-rt-ctl switch " + name + " 1";
  if (registry_.grantOf(event.joint) != event.grant) return;
  if (registry_.isActive(event.plugin)) {
    stop(event);
  } else if (registry_.state(event.plugin) == PluginState::kFailed) {
    log_.error("Since the plugin " + name + " failed, " + fallen(event) + upTo(event) +
               ". To come back: robotui-rt-ctl reload " + name + ", then " + start + ".");
  } else {
    log_.error("Since the process of the plugin " + name + " is gone, " + fallen(event) + upTo(event) +
               ". To come back, when it is stopped again: " + start + ".");
  }
}

void JointEvents::stop(const JointEvent& event) {
  const std::string& name = registry_.name(event.plugin);
  const std::string before =
      event.cause == FallCause::kEmergency ? "release the emergency stop, look at the robot, then " : "";
  const std::string sentence = causeOf(event) + upTo(event) + ": " + fallen(event) +
                               ", and the plugin is stopped. To come back: " + before + "robotui-rt-ctl switch " +
                               name + " 1.";
  log_.error(sentence);
  if (registry_.state(event.plugin) != PluginState::kStopping) {
    hosts_[registry_.host(event.plugin)].child().socket().send("stop " + name);
  }
  registry_.fell(event.plugin, sentence);
  pending_.settle(Awaited::kStart, event.plugin, "error " + sentence);
}

std::string JointEvents::joint(std::uint16_t index) const {
  return index < config_.robot.joints.size() ? config_.robot.joints[index].name : "?";
}

std::string JointEvents::fallen(const JointEvent& event) const {
  std::string names;
  std::size_t named = 0;
  for (std::uint16_t i = 0; i < config_.robot.joints.size(); ++i) {
    if (event.joints.test(i) && named < kNamed) {
      names += (named++ == 0 ? "" : ", ") + joint(i);
    }
  }
  const std::size_t count = event.joints.count();
  const std::string more = count > named ? " and " + std::to_string(count - named) + " more" : std::string();
  return count == 1 ? "the joint " + names + " is in its safe state"
                    : "the joints " + names + more + " are in their safe state";
}

std::string JointEvents::causeOf(const JointEvent& event) const {
  const std::string& name = registry_.name(event.plugin);
  std::ostringstream text;
  switch (event.cause) {
    case FallCause::kNone: break;
    case FallCause::kMissed: return missed(event);
    case FallCause::kEmergency: return stops_.causeOf(event.stops);
    case FallCause::kRejected:
      return "What the plugin " + name + " commands the joint " + joint(event.joint) + " " + wordsOf(event.objection) +
             ", " + std::to_string(config_.hal.misses_before_safe) + " times in turn";
    case FallCause::kHardware:
      return "The hardware did not answer, or said that it cannot go on, for " +
             std::to_string(config_.hal.misses_before_safe) + " cycles";
    case FallCause::kFollowing:
      text << "The joint " << joint(event.joint) << " was " << std::setprecision(3) << event.error
           << " away from where the plugin " << name << " told it to be for " << config_.hal.following_time
           << " s (following_error allows " << config_.hal.following_errors.at(event.joint) << ")";
      return text.str();
  }
  return "The plugin " + name + " fell";
}

std::string JointEvents::missed(const JointEvent& event) const {
  const config::PluginPlan& planned = plan_.plugins[event.plugin];
  const config::ThreadConfig& thread = plan_.hosts[planned.host].threads[planned.thread];
  return "The plugin " + registry_.name(event.plugin) + " did not answer in time " +
         std::to_string(config_.hal.misses_before_safe) + " times in turn (its thread " + thread.name + " has " +
         milliseconds(std::chrono::nanoseconds(thread.period).count()) + slowest(event.plugin) + ")";
}

// All plugins of a thread share its time.
std::string JointEvents::slowest(std::uint32_t plugin) const {
  const config::PluginPlan& planned = plan_.plugins[plugin];
  const auto& segment = hosts_[planned.host].segment();
  std::int64_t longest = 0;
  std::string text;
  for (std::uint32_t i = 0; i < registry_.size(); ++i) {
    const bool is_beside = plan_.plugins[i].host == planned.host && plan_.plugins[i].thread == planned.thread;
    const std::int64_t busy = link::relaxedLoad(segment->plugins[i].last_busy_ns);
    if (is_beside && busy > longest && busy < kLongestCall) {
      longest = busy;
      text = ", the last call of " + registry_.name(i) + " took " + milliseconds(busy);
    }
  }
  return text;
}

}  // namespace robotui::rt::supervisor
