// What CartesianTasks says of itself: the first task that is not where it should be, and why.
#include <algorithm>
#include <charconv>

#include "cartesian_tasks.h"

namespace robotui::rt::plugins {
namespace {

struct Number {
  std::array<char, 32> room{};

  std::string_view operator()(double value) noexcept {
    const auto [end, error] = std::to_chars(room.data(), room.data() + room.size(), value, std::chars_format::fixed, 3);
    return error == std::errc() ? std::string_view(room.data(), static_cast<std::size_t>(end - room.data())) : "?";
  }
};

}  // namespace

// A task that something holds back comes before one that only is on its way.
void CartesianTasks::say() noexcept {
  const Task* late = nullptr;
  bool is_late_held = false;
  bool is_led = false;
  for (const Task& task : tasks_) {
    if (!task.does.isActive()) continue;
    is_led |= task.does.isLedByVelocity();
    const bool is_held = task.does.isStuck() || task.hindrance != Hindrance::kNone;
    if (task.does.isThere() && !(is_held && task.does.isLedByVelocity())) continue;
    if (late == nullptr || (is_held && !is_late_held)) {
      late = &task;
      is_late_held = is_held;
    }
  }
  if (late != nullptr && (is_late_held || !late->does.isLedByVelocity()))
    sayOf(*late);
  else
    status_.assign(is_led ? "moving with a velocity" : "all tasks are at their targets");
  if (distances_) sayNearest();
}

void CartesianTasks::sayNearest() noexcept {
  const PartDistances::Pair& nearest = distances_->nearest();
  Number number;
  status_.append("; nearest are ").append(distances_->linkA(nearest)).append(" and ");
  status_.append(distances_->linkB(nearest)).append(" with ").append(number(nearest.distance)).append(" m");
}

void CartesianTasks::sayOf(const Task& task) noexcept {
  status_.assign(task.does.description().name);
  if (task.hindrance == Hindrance::kNone && !task.does.isStuck()) {
    status_.append(" is moving");
    return;
  }
  Number number;
  status_.append(task.does.isStuck() ? " cannot go on, " : " is ").append(number(task.does.metres())).append(" m and ");
  status_.append(number(task.does.radians())).append(" rad from its target: ");
  switch (task.hindrance) {
    case Hindrance::kLimit: status_.append(joints_->joint(task.which).name()).append(" is at its limit"); break;
    case Hindrance::kNone:
    case Hindrance::kSingular: status_.append("it is at the end of its reach, or in a singular posture"); break;
    case Hindrance::kDistance:
      status_.append(distances_->linkA(*task.pair)).append(" and ").append(distances_->linkB(*task.pair));
      status_.append(" keep their distance");
      break;
    case Hindrance::kPriority: status_.append("a task of higher priority needs the joints"); break;
  }
}

void CartesianTasks::openReport(Setup& setup) {
  for (Eigen::Index i = 0; i < joints_->size(); ++i) addJoint(report_, joints_->joint(i).index());
  report_.count = static_cast<std::uint32_t>(std::min(tasks_.size(), report_.tasks.size()));
  for (std::size_t i = 0; i < report_.count; ++i) {
    const TaskDescription& task = tasks_[i].does.description();
    TaskReport::Task& said = report_.tasks[i];
    assign(said.name, task.name);
    assign(said.link, task.link);
    assign(said.base, task.base);
    said.linear = task.speeds.linear;
    said.angular = task.speeds.angular;
    said.priority = static_cast<std::uint32_t>(task.priority);
    for (std::size_t axis = 0; axis < task.mask.size(); ++axis) said.mask |= task.mask[axis] ? 1U << axis : 0U;
  }
  reports_ = ChannelWriter<TaskReport>(setup.channels(), taskChannel(setup.name()), kTaskDepth);
  report();
}

void CartesianTasks::report() noexcept {
  for (std::size_t i = 0; i < report_.count; ++i) {
    const CartesianTask& task = tasks_[i].does;
    const bool is_there = task.isThere() && !task.isLedByVelocity();
    report_.tasks[i].phase = !task.isActive() ? TaskPhase::kDisabled
                             : task.isStuck() ? TaskPhase::kStuck
                             : is_there       ? TaskPhase::kThere
                                              : TaskPhase::kMoving;
  }
  reports_.write(report_);
}

}  // namespace robotui::rt::plugins
