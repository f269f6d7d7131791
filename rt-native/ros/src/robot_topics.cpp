#include "robot_topics.h"

#include <std_srvs/SetBool.h>
#include <xbot_msgs/PluginCommand.h>
#include <xbot_msgs/PluginStatus.h>

#include "conversions.h"
#include "robotui/rt/link/clock.h"

namespace robotui::rt::ros_bridge {
namespace {

constexpr std::uint32_t kQueue = 10;
constexpr std::int64_t kTransformsEvery = 20 * link::kMillisecond;
constexpr std::int64_t kComplaintEvery = link::kSecond;
constexpr const char* kCommandType = "xbot_msgs/JointCommand";

// The state was sensed a little while ago; the clock of ROS is that of the day.
ros::Time stampOf(std::int64_t sensed_ns) {
  const ros::WallTime now = ros::WallTime::now();
  const std::int64_t age = std::max<std::int64_t>(link::now() - sensed_ns, 0);
  ros::Time stamp;
  return stamp.fromNSec(static_cast<std::uint64_t>(static_cast<std::int64_t>(now.toNSec()) - age));
}

}  // namespace

RobotTopics::RobotTopics(const config::RtConfig& config, const config::Plan& plan, const Transforms& transforms,
                         Robot& robot, Requests& requests, ros::CallbackQueue& services, LogFunction log)
    : transforms_(transforms), robot_(robot), requests_(requests), log_(std::move(log)),
      shows_references_(config.enable_ref_read) {
  services_.setCallbackQueue(&services);
  node_.setParam("robot_description", config.robot.urdf);
  for (const auto& joint : config.robot.joints) names_.push_back(joint.name);
  offerState();
  offerSensors(config);
  for (const auto& each : plan.plugins) offerPlugin(each.plugin.name);
  takeCommands();
}

void RobotTopics::offerState() {
  states_ = node_.advertise<xbot_msgs::JointState>("joint_states", kQueue);
  moving_ = node_.advertise<tf2_msgs::TFMessage>("/tf", kQueue);
  if (transforms_.fixed().empty()) return;
  fixed_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
  tf2_msgs::TFMessage message;
  message.transforms = transforms_.fixed();
  for (auto& each : message.transforms) each.header.stamp = stampOf(link::now());
  fixed_.publish(message);
}

void RobotTopics::offerSensors(const config::RtConfig& config) {
  for (const auto& sensor : config.robot.imus) {
    imus_.push_back({node_.advertise<sensor_msgs::Imu>("imu/" + rosName(sensor.name), kQueue), {}});
    imus_.back().message.header.frame_id = sensor.link;
  }
  for (const auto& sensor : config.robot.force_torques) {
    wrenches_.push_back({node_.advertise<geometry_msgs::WrenchStamped>("ft/" + rosName(sensor.name), kQueue), {}});
    wrenches_.back().message.header.frame_id = sensor.link;
  }
}

void RobotTopics::offerPlugin(const std::string& name) {
  const std::string topic = rosName(name);
  verbs_.push_back(services_.advertiseService<std_srvs::SetBool::Request, std_srvs::SetBool::Response>(
      topic + "_switch", [this, name](std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
        const link::Reply reply = requests_.ask("switch " + name + (request.data != 0 ? " 1" : " 0"));
        response.success = reply.ok;
        response.message = reply.text;
        return true;
      }));
  verbs_.push_back(services_.advertiseService<xbot_msgs::PluginCommand::Request, xbot_msgs::PluginCommand::Response>(
      topic + "_cmd",
      [this, name](xbot_msgs::PluginCommand::Request& request, xbot_msgs::PluginCommand::Response& response) {
        const link::Reply reply = requests_.ask("command " + name + " " + request.cmd.substr(0, link::kTextLength));
        response.success = reply.ok;
        if (!reply.ok) log_("warn", name + "_cmd was refused: " + reply.text);
        return true;
      }));
  verbs_.push_back(services_.advertiseService<xbot_msgs::PluginStatus::Request, xbot_msgs::PluginStatus::Response>(
      topic + "_status", [this, name](xbot_msgs::PluginStatus::Request&, xbot_msgs::PluginStatus::Response& response) {
        response.status = requests_.ask("status " + name).text;
        return true;
      }));
}

// Versions of xbot_msgs differ in their fields: every one is taken, and read by the definition that its publisher sends
// along.
void RobotTopics::takeCommands() {
  ros::SubscribeOptions options("command", 1, "*", kCommandType);
  using Event = ros::MessageEvent<RawMessage const>;
  options.helper = boost::make_shared<ros::SubscriptionCallbackHelperT<const Event&>>(
      [this](const Event& event) { command(event); });
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  commands_ = node_.subscribe(options);
}

void RobotTopics::command(const ros::MessageEvent<RawMessage const>& event) {
  try {
    const auto& header = event.getConnectionHeader();
    const auto type = header.find("type");
    const auto definition = header.find("message_definition");
    if (type == header.end() || type->second != kCommandType || definition == header.end()) {
      complain("A command came from " + event.getPublisherName() + " that is no " + kCommandType +
               ": it does not count.");
      return;
    }
    const Columns columns = MessageShape::parse(definition->second).read(event.getConstMessage()->bytes);
    std::string objection = readCommand(columns, names_, references_);
    if (objection.empty()) objection = robot_.reference(references_);
    if (!objection.empty()) complain("A command from " + event.getPublisherName() + " does not count: " + objection);
  } catch (const std::exception& e) {
    complain("A command from " + event.getPublisherName() + " does not count: " + e.what());
  }
}

void RobotTopics::complain(const std::string& line) {
  const std::int64_t now = link::now();
  if (now - complained_ns_ < kComplaintEvery) return;
  complained_ns_ = now;
  log_("warn", line);
}

void RobotTopics::publish() {
  if (!robot_.sense()) return;
  const ros::Time stamp = stampOf(robot_.frame().sensed_ns);
  fill(state_, names_, robot_.joints());
  if (!shows_references_) hideReferences(state_);
  state_.header.stamp = stamp;
  states_.publish(state_);
  publishSensors(stamp);
  publishTransforms(stamp);
}

void RobotTopics::publishSensors(const ros::Time& stamp) {
  for (std::size_t i = 0; i < imus_.size(); ++i) {
    fill(imus_[i].message, robot_.frame().imus[i]);
    imus_[i].message.header.stamp = stamp;
    imus_[i].publisher.publish(imus_[i].message);
  }
  for (std::size_t i = 0; i < wrenches_.size(); ++i) {
    fill(wrenches_[i].message, robot_.frame().force_torques[i]);
    wrenches_[i].message.header.stamp = stamp;
    wrenches_[i].publisher.publish(wrenches_[i].message);
  }
}

void RobotTopics::publishTransforms(const ros::Time& stamp) {
  const std::int64_t now = link::now();
  if (now - transforms_ns_ < kTransformsEvery) return;
  transforms_ns_ = now;
  tf2_msgs::TFMessage message;
  message.transforms = transforms_.moving(robot_.joints());
  for (auto& each : message.transforms) each.header.stamp = stamp;
  moving_.publish(message);
}

}  // namespace robotui::rt::ros_bridge
