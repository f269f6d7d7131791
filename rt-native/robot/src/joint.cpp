#include "robotui/rt/robot/xbot_interface.h"

namespace robotui::rt {
namespace {

void add(link::JointCommand& command, std::uint8_t bit) noexcept {
  command.mode = static_cast<std::uint8_t>(command.mode | bit);
}

}  // namespace

Joint::Joint(const config::JointDescription& description, int index, link::JointState& state,
             link::JointCommand& command)
    : description_(&description), index_(index), state_(&state), command_(&command) {}

const std::string& Joint::name() const noexcept { return description_->name; }
int Joint::id() const noexcept { return description_->id; }
int Joint::index() const noexcept { return index_; }
const config::JointDescription& Joint::description() const noexcept { return *description_; }

double Joint::getJointPosition() const noexcept { return state_->link_position; }
double Joint::getMotorPosition() const noexcept { return state_->motor_position; }
double Joint::getJointVelocity() const noexcept { return state_->link_velocity; }
double Joint::getMotorVelocity() const noexcept { return state_->motor_velocity; }
double Joint::getJointEffort() const noexcept { return state_->effort; }
double Joint::getStiffness() const noexcept { return state_->stiffness; }
double Joint::getDamping() const noexcept { return state_->damping; }
double Joint::getPositionReference() const noexcept { return state_->position_reference; }
double Joint::getVelocityReference() const noexcept { return state_->velocity_reference; }
double Joint::getEffortReference() const noexcept { return state_->effort_reference; }
std::uint32_t Joint::fault() const noexcept { return state_->fault; }

void Joint::setPositionReference(double rad) noexcept {
  command_->position = rad;
  add(*command_, link::kPosition);
}

void Joint::setVelocityReference(double rad_s) noexcept {
  command_->velocity = rad_s;
  add(*command_, link::kVelocity);
}

void Joint::setEffortReference(double nm) noexcept {
  command_->effort = nm;
  add(*command_, link::kEffort);
}

void Joint::setStiffness(double nm_rad) noexcept {
  command_->stiffness = nm_rad;
  add(*command_, link::kStiffness);
}

void Joint::setDamping(double nms_rad) noexcept {
  command_->damping = nms_rad;
  add(*command_, link::kDamping);
}

void Joint::setMode(std::uint8_t mode) noexcept { command_->mode = mode; }
void Joint::clear() noexcept { command_->mode = 0; }

const link::JointState& Joint::state() const noexcept { return *state_; }
const link::JointCommand& Joint::command() const noexcept { return *command_; }

}  // namespace robotui::rt
