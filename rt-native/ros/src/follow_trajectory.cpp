#include "follow_trajectory.h"

#include <algorithm>

#include <control_msgs/FollowJointTrajectoryActionResult.h>

#include "conversions.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::ros_bridge {
namespace {

using ActionGoal = control_msgs::FollowJointTrajectoryActionGoal;

constexpr std::uint32_t kQueue = 10;
constexpr double kTurnSeconds = 0.005;
constexpr std::int64_t kFeedbackEvery = 50 * link::kMillisecond;
constexpr std::int64_t kStatusEvery = 200 * link::kMillisecond;
constexpr std::int64_t kToBegin = 5 * link::kSecond;  // until a plugin has checked what it was told
constexpr std::int64_t kSilence = 2 * link::kSecond;  // of a plugin that runs

std::vector<std::size_t> indicesOf(const std::vector<std::string>& names, const std::vector<std::string>& all) {
  std::vector<std::size_t> indices;
  for (const std::string& name : names)
    indices.push_back(static_cast<std::size_t>(std::find(all.begin(), all.end(), name) - all.begin()));
  return indices;
}

bool isRefused(TrajectoryPhase phase) noexcept {
  return phase == TrajectoryPhase::kRefused || phase == TrajectoryPhase::kBadJoints;
}

std::int32_t codeOf(TrajectoryPhase refused) noexcept {
  return refused == TrajectoryPhase::kBadJoints ? TrajectoryResult::INVALID_JOINTS : TrajectoryResult::INVALID_GOAL;
}

}  // namespace

FollowTrajectory::FollowTrajectory(const std::string& plugin, const std::string& robot, std::vector<std::string> joints,
                                   const ChannelDirectory& channels, LogFunction log)
    : plugin_(plugin), joints_(std::move(joints)), log_(std::move(log)),
      shape_(MessageShape::parse(::ros::message_traits::definition<ActionGoal>())), requests_(robot),
      robot_(robot, joints_.size()), reports_(channels, trajectoryChannel(plugin), OtherSchema::kAwait),
      node_("/xbotcore/" + rosName(plugin) + "/follow_joint_trajectory") {
  open();
}

void FollowTrajectory::open() {
  node_.setCallbackQueue(&queue_);
  statuses_ = node_.advertise<actionlib_msgs::GoalStatusArray>("status", kQueue);
  feedbacks_ = node_.advertise<control_msgs::FollowJointTrajectoryActionFeedback>("feedback", kQueue);
  results_ = node_.advertise<control_msgs::FollowJointTrajectoryActionResult>("result", kQueue);
  ::ros::SubscribeOptions options("goal", kQueue, ::ros::message_traits::md5sum<ActionGoal>(),
                                  ::ros::message_traits::datatype<ActionGoal>());
  options.helper = boost::make_shared<::ros::SubscriptionCallbackHelperT<const RawMessage::ConstPtr&>>(
      [this](const RawMessage::ConstPtr& message) { take(*message); });
  options.transport_hints = ::ros::TransportHints().tcpNoDelay();
  goal_ = node_.subscribe(options);
  cancel_ = node_.subscribe<actionlib_msgs::GoalID>(
      "cancel", kQueue, [this](const actionlib_msgs::GoalID::ConstPtr& which) { cancel(*which); });
  thread_ = std::thread([this] { work(); });
}

FollowTrajectory::~FollowTrajectory() {
  goes_on_ = false;
  thread_.join();
}

void FollowTrajectory::work() {
  while (goes_on_) {
    try {
      queue_.callAvailable(::ros::WallDuration(kTurnSeconds));
      turn();
    } catch (const std::exception& e) {
      log_("error", "the action of " + plugin_ + ": " + e.what());
    }
  }
}

void FollowTrajectory::turn() {
  robot_.keep();
  if (pending_ && pending_->tag == 0 && ::ros::Time::now() >= pending_->start) tell();
  const bool is_heard = look();
  if (is_heard && pending_ && pending_->tag != 0) followPending();
  if (active_) followActive();
  if (link::now() - listed_ns_ > kStatusEvery) publishStatus();
}

// False where the plugin has never said anything.
bool FollowTrajectory::look() {
  const double before = report_.seconds;
  const bool is_read = reports_.latest(report_);
  if (is_read && report_.seconds != before) reported_ns_ = link::now();
  return is_read;
}

// ---- what comes -----------------------------------------------------------------------------------------------------

void FollowTrajectory::take(const RawMessage& message) {
  if (!shape_.fits(message.bytes)) {
    log_("warn", "a goal of " + plugin_ + " is not one whole message: it does not count");
    return;
  }
  std::vector<std::uint8_t> bytes = message.bytes;  // ROS reads from what it may write
  ::ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ActionGoal goal;
  ::ros::serialization::deserialize(stream, goal);
  take(goal);
}

void FollowTrajectory::take(const ActionGoal& message) {
  const ::ros::Time now = ::ros::Time::now();
  actionlib_msgs::GoalID id = message.goal_id;
  if (id.id.empty()) id.id = node_.getNamespace() + "-" + std::to_string(++named_) + "-" + std::to_string(now.toSec());
  if (id.stamp.isZero()) id.stamp = now;
  if (!goals_.add(id, now)) {
    const GoalStatus* known = goals_.find(id.id);
    if (known != nullptr && known->status == GoalStatus::RECALLED) end(id.id, known->status, resultOf(0, known->text));
    return;
  }
  if (const auto objection = objectionTo(message.goal, joints_, now)) {
    end(id.id, GoalStatus::REJECTED, *objection);
    return;
  }
  if (pending_) {
    if (!pending_->stop.empty()) ask(pending_->stop);
    endPending(GoalStatus::RECALLED, resultOf(0, "another goal came before it began"));
  }
  pending_.emplace(Pending{id.id, message.goal, startOf(message.goal, now), 0, {}, 0, false});
  publishStatus();
}

void FollowTrajectory::cancel(const actionlib_msgs::GoalID& which) {
  for (const std::string& id : goals_.cancel(which, ::ros::Time::now())) {
    if (pending_ && pending_->id == id) {
      pending_->cancelled = true;
      if (pending_->tag == 0)
        endPending(GoalStatus::RECALLED, resultOf(0, "cancelled before it began"));
      else
        ask(pending_->stop);
    } else if (active_ && active_->id == id) {
      active_->cancelled = true;
      ask(active_->stop);
    }
  }
  publishStatus();
}

// ---- the plugin -----------------------------------------------------------------------------------------------------

link::Reply FollowTrajectory::ask(const std::string& order) {
  return requests_.ask("command " + plugin_ + " " + order);
}

// What it says of an order that it refuses stands in its report.
void FollowTrajectory::tell() {
  link::TrajectoryOrders orders = ordersOf(pending_->goal, ::ros::Time::now());
  pending_->tag = orders.tag();
  pending_->stop = orders.stop();
  pending_->told_ns = link::now();
  for (const std::string& order : orders.take()) {
    const link::Reply reply = ask(order);
    if (reply.ok) continue;
    for (std::int64_t until = link::now() + kSilence; link::now() < until && goes_on_;) {
      if (look() && report_.told == pending_->tag && isRefused(report_.told_phase)) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    endPending(GoalStatus::REJECTED, resultOf(TrajectoryResult::INVALID_GOAL, reply.text));
    return;
  }
}

void FollowTrajectory::followPending() {
  const bool is_told = report_.told == pending_->tag;
  if (report_.followed == pending_->tag) {
    accept();
  } else if (is_told && isRefused(report_.told_phase)) {
    endPending(pending_->cancelled ? GoalStatus::RECALLED : GoalStatus::REJECTED,
               resultOf(pending_->cancelled ? 0 : codeOf(report_.told_phase), std::string(view(report_.refusal))));
  } else if (!is_told) {
    endPending(GoalStatus::REJECTED,
               resultOf(TrajectoryResult::INVALID_GOAL, "another client told " + plugin_ + " another trajectory"));
  } else if (link::now() - pending_->told_ns > kToBegin) {
    ask(pending_->stop);
    endPending(GoalStatus::REJECTED, resultOf(TrajectoryResult::INVALID_GOAL, plugin_ + " did not begin it in time"));
  }
}

// It has taken over from the one before.
void FollowTrajectory::accept() {
  if (active_) endActive(GoalStatus::PREEMPTED, resultOf(0, "another goal took over"));
  active_.emplace(Active{pending_->id,
                         pending_->tag,
                         pending_->stop,
                         indicesOf(pending_->goal.trajectory.joint_names, joints_),
                         {},
                         pending_->cancelled});
  active_->feedback.feedback.joint_names = pending_->goal.trajectory.joint_names;
  pending_.reset();
  reported_ns_ = link::now();
  goals_.set(active_->id, active_->cancelled ? GoalStatus::PREEMPTING : GoalStatus::ACTIVE, "", ::ros::Time::now());
  publishStatus();
}

void FollowTrajectory::followActive() {
  const std::string ending(view(report_.ending));
  if (report_.followed != active_->tag) {
    if (pending_ && report_.followed == pending_->tag) return;
    endActive(GoalStatus::PREEMPTED, resultOf(0, "another client told " + plugin_ + " another trajectory"));
    return;
  }
  switch (report_.phase) {
    case TrajectoryPhase::kDone: endActive(GoalStatus::SUCCEEDED, resultOf(TrajectoryResult::SUCCESSFUL, "")); return;
    case TrajectoryPhase::kOffPath:
      endActive(GoalStatus::ABORTED, resultOf(TrajectoryResult::PATH_TOLERANCE_VIOLATED, ending));
      return;
    case TrajectoryPhase::kOffGoal:
      endActive(GoalStatus::ABORTED, resultOf(TrajectoryResult::GOAL_TOLERANCE_VIOLATED, ending));
      return;
    case TrajectoryPhase::kStopped:
      if (active_->cancelled)
        endActive(GoalStatus::PREEMPTED, resultOf(0, "cancelled"));
      else
        endActive(GoalStatus::ABORTED, resultOf(TrajectoryResult::PATH_TOLERANCE_VIOLATED, ending));
      return;
    default: break;
  }
  const std::int64_t now = link::now();
  if (now - reported_ns_ > kSilence) {
    endActive(GoalStatus::ABORTED, resultOf(TrajectoryResult::PATH_TOLERANCE_VIOLATED,
                                            plugin_ + " is " + requests_.ask("status " + plugin_).text));
  } else {
    giveFeedback(now);
  }
}

void FollowTrajectory::giveFeedback(std::int64_t now) {
  if (now - fed_ns_ < kFeedbackEvery) return;
  robot_.sense();
  const auto& measured = robot_.joints();
  if (robot_.frame().cycle == 0) return;
  fed_ns_ = now;
  auto& feedback = active_->feedback.feedback;
  for (auto* point : {&feedback.desired, &feedback.actual, &feedback.error}) {
    point->positions.clear();
    point->velocities.clear();
    point->accelerations.clear();
    point->time_from_start = ::ros::Duration(report_.seconds);
  }
  for (const std::size_t joint : active_->joints) {
    feedback.desired.positions.push_back(report_.positions[joint]);
    feedback.desired.velocities.push_back(report_.velocities[joint]);
    feedback.desired.accelerations.push_back(report_.accelerations[joint]);
    feedback.actual.positions.push_back(measured[joint].link_position);
    feedback.actual.velocities.push_back(measured[joint].link_velocity);
    feedback.error.positions.push_back(report_.positions[joint] - measured[joint].link_position);
    feedback.error.velocities.push_back(report_.velocities[joint] - measured[joint].link_velocity);
  }
  active_->feedback.header.stamp = feedback.header.stamp = ::ros::Time::now();
  if (const GoalStatus* status = goals_.find(active_->id)) active_->feedback.status = *status;
  feedbacks_.publish(active_->feedback);
}

// ---- ends -----------------------------------------------------------------------------------------------------------

void FollowTrajectory::endPending(std::uint8_t status, const TrajectoryResult& result) {
  const std::string id = pending_->id;
  pending_.reset();
  end(id, status, result);
}

void FollowTrajectory::endActive(std::uint8_t status, const TrajectoryResult& result) {
  const std::string id = active_->id;
  active_.reset();
  end(id, status, result);
}

void FollowTrajectory::end(const std::string& id, std::uint8_t status, const TrajectoryResult& result) {
  const ::ros::Time now = ::ros::Time::now();
  goals_.set(id, status, result.error_string, now);
  control_msgs::FollowJointTrajectoryActionResult message;
  message.header.stamp = now;
  if (const GoalStatus* known = goals_.find(id)) message.status = *known;
  message.result = result;
  results_.publish(message);
  publishStatus();
}

void FollowTrajectory::publishStatus() {
  listed_ns_ = link::now();
  statuses_.publish(goals_.list(::ros::Time::now()));
}

}  // namespace robotui::rt::ros_bridge
