#include "cartesian_tasks.h"

#include <algorithm>
#include <cmath>

#include "chosen_joints.h"
#include "numbers.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kPostureGain = 2;  // 1/s
constexpr double kHindered = 0.2;   // part of its velocity that a task lacks when something is in its way
constexpr double kHeldBack = 1e-4;  // m/s by which a bounded approach is at its bound
constexpr double kSlow = 2e-3;      // m/s or rad/s that are not worth to be told

void warnOfMeshes(Setup& setup, const PartDistances& distances) {
  const auto& links = distances.meshLinks();
  if (links.empty()) return;
  const std::string line = "The distances of " + std::to_string(links.size()) + " links with meshes (" + links.front() +
                           (links.size() > 1 ? ", ..." : "") + ") are not kept: give them `capsules`.";
  setup.log().warn(line);
}

}  // namespace

bool CartesianTasks::init_control_plugin(Setup& setup) {
  const config::Reader params(setup.params(), {}, setup.name());
  TaskParameters parameters = readTaskParameters(params, setup.robot());
  robot_ = &setup.robot().description();
  model_ = setup.createModel();
  joints_.emplace(parameters.joints, setup.robot(), *model_);
  const Eigen::Index joints = joints_->size();
  Eigen::Index most_rows = joints;
  Eigen::Index rows = 0;
  for (TaskDescription& description : parameters.tasks) {
    tasks_.push_back({CartesianTask(std::move(description), *model_, joints_->places())});
    rows += tasks_.back().does.rows();
  }
  most_rows = std::max(most_rows, rows);
  bounds_.emplace(joints);
  if (parameters.distance) {
    distances_.emplace(*robot_, std::move(*parameters.distance), joints_->places());
    approach_.emplace(PartDistances::kMostRows, joints);
    warnOfMeshes(setup, *distances_);
  }
  hierarchy_.emplace(joints, most_rows, PartDistances::kMostRows);
  rows_.setZero(most_rows, joints);
  wanted_.setZero(most_rows);
  each_joint_.setIdentity(joints, joints);
  posture_.setZero(joints);
  first_posture_ = parameters.posture;
  posture_speed_ = parameters.posture_speed;
  setup.claim(namesOf(parameters.joints));
  openReport(setup);
  status_.assign("stopped");
  return true;
}

RtStatus CartesianTasks::on_start(double /*time*/) noexcept {
  joints_->start(*model_);
  update();
  for (Task& task : tasks_) {
    task.hindrance = Hindrance::kNone;
    task.does.rest();
  }
  for (Eigen::Index i = 0; i < joints_->size(); ++i) posture_[i] = joints_->position(i);
  if (!first_posture_.empty()) setPosture(first_posture_);
  return RtStatus::ok();
}

void CartesianTasks::update() noexcept {
  for (Task& task : tasks_) task.does.update(*model_);
  if (distances_) distances_->update(joints_->all());
}

void CartesianTasks::begin(double period) noexcept {
  joints_->bound(*bounds_, period);
  if (distances_) distances_->put(*approach_);
  hierarchy_->begin(*bounds_, approach_ ? &*approach_ : nullptr);
}

RtStatus CartesianTasks::control_loop(double /*time*/, double period) noexcept {
  begin(period);
  solveTasks(period);
  solvePosture();
  joints_->move(hierarchy_->velocities(), period, *model_);
  update();
  say();
  report();
  return RtStatus::ok();
}

// Tasks of one priority are one level.
void CartesianTasks::solveTasks(double period) noexcept {
  bool is_first = true;
  for (auto first = tasks_.begin(); first != tasks_.end();) {
    const int priority = first->does.description().priority;
    Eigen::Index count = 0;
    auto end = first;
    for (; end != tasks_.end() && end->does.description().priority == priority; ++end) {
      end->row = count;
      if (!end->does.isActive()) continue;
      const Eigen::Index rows = end->does.rows();
      end->does.put(period, rows_.middleRows(count, rows), wanted_.segment(count, rows));
      count += rows;
    }
    if (count > 0) {
      const LevelOutcome outcome = hierarchy_->solve(rows_.topRows(count), wanted_.head(count), true);
      for (auto task = first; task != end; ++task) findHindrance(*task, outcome, is_first);
      is_first = false;
    }
    first = end;
  }
}

// Why a task does not move as it wants, by what holds the joints back.
void CartesianTasks::findHindrance(Task& task, const LevelOutcome& outcome, bool is_first) noexcept {
  if (!task.does.isStuck()) task.hindrance = Hindrance::kNone;  // else what it was is still what it is
  if (!task.does.isActive()) return;
  const Eigen::VectorXd& velocities = hierarchy_->velocities();
  double lack = 0;
  double length = 0;
  for (Eigen::Index row = task.row; row < task.row + task.does.rows(); ++row) {
    const double missing = wanted_[row] - rows_.row(row).dot(velocities);
    lack += missing * missing;
    length += wanted_[row] * wanted_[row];
  }
  if (std::sqrt(lack) < kSlow + kHindered * std::sqrt(length)) return;
  if (const PartDistances::Pair* pair = findPair(task)) {
    task.hindrance = Hindrance::kDistance;
    task.pair = pair;
    return;
  }
  for (Eigen::Index i = 0; i < joints_->size(); ++i) {
    if (rows_.col(i).segment(task.row, task.does.rows()).norm() < kSlow) continue;
    if (!joints_->isAtLimit(i, velocities[i], *bounds_)) continue;
    task.hindrance = Hindrance::kLimit;
    task.which = i;
    return;
  }
  if (outcome.is_lost && !is_first)
    task.hindrance = Hindrance::kPriority;
  else if (outcome.is_lost || outcome.is_damped)
    task.hindrance = Hindrance::kSingular;
}

// A pair of parts that does not come nearer as fast as the task would have it.
const PartDistances::Pair* CartesianTasks::findPair(const Task& task) const noexcept {
  if (!approach_) return nullptr;
  const Eigen::VectorXd& velocities = hierarchy_->velocities();
  const auto rows = rows_.middleRows(task.row, task.does.rows());
  for (Eigen::Index i = 0; i < approach_->count; ++i) {
    const auto row = approach_->rows.row(i);
    if (row.dot(velocities) > approach_->lower[i] + kHeldBack) continue;
    for (Eigen::Index axis = 0; axis < rows.rows(); ++axis) {
      if (std::abs(rows.row(axis).dot(row)) > kSlow) return &distances_->pairOf(i);
    }
  }
  return nullptr;
}

void CartesianTasks::solvePosture() noexcept {
  const Eigen::Index count = joints_->size();
  for (Eigen::Index i = 0; i < count; ++i) {
    const double most = posture_speed_ * std::max(joints_->joint(i).description().velocity, 0.0);
    wanted_[i] = std::clamp(kPostureGain * (posture_[i] - joints_->position(i)), -most, most);
  }
  hierarchy_->solve(each_joint_, wanted_.head(count), false);
}

void CartesianTasks::on_stop(double /*time*/) noexcept { status_.assign("stopped"); }

bool CartesianTasks::on_command(std::string_view words) {
  const std::string_view verb = takeWord(words);
  if (verb == "posture") return setPosture(takeWord(words)) && words.empty();
  if (verb == "stop" && words.empty()) {
    for (Task& task : tasks_) task.does.stop();
    return setPosture({});
  }
  Task* task = findTask(takeWord(words));
  return task != nullptr && obey(verb, *task, words);
}

CartesianTasks::Task* CartesianTasks::findTask(std::string_view name) noexcept {
  const auto found = std::find_if(tasks_.begin(), tasks_.end(),
                                  [&](const Task& task) { return task.does.description().name == name; });
  return found == tasks_.end() ? nullptr : &*found;
}

bool CartesianTasks::obey(std::string_view verb, Task& task, std::string_view words) noexcept {
  double numbers[6] = {};
  const int count = readNumbers(words, numbers, 6);
  if (count == 0 && (verb == "enable" || verb == "disable")) {
    task.does.setActive(verb == "enable");
    return true;
  }
  if (count == 0 && verb == "stop") {
    task.does.stop();
    return true;
  }
  if ((count != 3 && count != 6) || !task.does.isActive()) return false;
  if (verb == "velocity") {
    task.does.setVelocity(Eigen::Map<const Twist>(numbers));
    return true;
  }
  if (verb != "pose" && verb != "move") return false;
  task.does.beginPath();
  return verb == "pose" ? task.does.path().setTarget(numbers, count) : task.does.path().moveTarget(numbers, count);
}

// Without a name the one that the joints have now. Joints that a posture does not name keep theirs.
bool CartesianTasks::setPosture(std::string_view name) noexcept {
  if (name.empty()) {
    for (Eigen::Index i = 0; i < joints_->size(); ++i) posture_[i] = joints_->position(i);
    return true;
  }
  bool is_known = false;
  for (const auto& posture : robot_->postures) {
    if (posture.name != name) continue;
    is_known = true;
    for (Eigen::Index i = 0; i < joints_->size(); ++i) {
      for (const auto& [joint, position] : posture.joints) {
        if (joint == joints_->joint(i).name()) posture_[i] = position;
      }
    }
  }
  return is_known;
}

}  // namespace robotui::rt::plugins
