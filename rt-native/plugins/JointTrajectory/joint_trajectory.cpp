#include "joint_trajectory.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "chosen_joints.h"
#include "held_position.h"
#include "numbers.h"

namespace robotui::rt::plugins {
namespace {

constexpr double kToRest =
    0.3;  // s in which a joint that is stopped comes to rest, on half of the way that it would go
constexpr int kMostNumbers = 128;

std::string_view wordOf(TrajectoryState state) noexcept {
  switch (state) {
    case TrajectoryState::kHolding: return "holding";
    case TrajectoryState::kReading: return "reading";
    case TrajectoryState::kChecking: return "checking";
    case TrajectoryState::kMoving: return "moving";
    case TrajectoryState::kSettling: return "settling";
    case TrajectoryState::kDone: return "done";
    case TrajectoryState::kRefused: return "refused";
    case TrajectoryState::kAborted: return "aborted";
    case TrajectoryState::kStopped: break;
  }
  return "stopped";
}

std::string_view textOf(double number, std::array<char, 32>& room) noexcept {
  const auto [end, error] = std::to_chars(room.data(), room.data() + room.size(), number, std::chars_format::fixed, 3);
  return error == std::errc() ? std::string_view(room.data(), static_cast<std::size_t>(end - room.data())) : "far";
}

// `@17 ` at the start, which it takes off; 0 where there is none. False where it is no number.
bool takeTag(std::string_view& words, std::uint64_t& tag) noexcept {
  tag = 0;
  if (!words.starts_with('@')) return true;
  std::string_view word = takeWord(words);
  word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), tag);
  return error == std::errc() && end == word.data() + word.size() && tag != 0;
}

}  // namespace

bool JointTrajectory::init_control_plugin(Setup& setup) {
  const config::Reader params(setup.params(), {}, setup.name());
  constexpr double kMost = 1000;
  defaults_.joint.path = params.realOr("path_tolerance", defaults_.joint.path, 0, kMost);
  defaults_.joint.goal = params.realOr("goal_tolerance", defaults_.joint.goal, 0, kMost);
  defaults_.goal_time = params.realOr("goal_time", defaults_.goal_time, 0, kMost);
  joints_ = chosenJoints(params, setup.robot());
  references_.resize(joints_.size());
  draft_ = std::make_unique<TrajectoryDraft>(joints_, defaults_);
  path_ = std::make_unique<JointPath>(joints_.size());
  tolerances_.resize(joints_.size());
  reports_ = ChannelWriter<TrajectoryReport>(setup.channels(), trajectoryChannel(setup.name()), kTrajectoryDepth);
  setup.claim(namesOf(joints_));
  enter(TrajectoryState::kHolding);
  return true;
}

RtStatus JointTrajectory::on_start(double time) {
  for (std::size_t i = 0; i < joints_.size(); ++i) references_[i] = {heldPosition(*joints_[i]), 0, 0};
  before_ = now_ = begun_ = time;
  moves_ = false;
  runs_ = true;
  enter(TrajectoryState::kHolding);
  report();
  return RtStatus::ok();
}

void JointTrajectory::on_stop(double /*time*/) {
  giveUp();
  runs_ = moves_ = false;
  if (report_.phase == TrajectoryPhase::kMoving || report_.phase == TrajectoryPhase::kSettling) {
    report_.phase = TrajectoryPhase::kStopped;
    assign(report_.ending, "the plugin was stopped");
    enter(TrajectoryState::kStopped);
  }
  report();
}

// What was told, but not begun yet.
void JointTrajectory::giveUp() noexcept {
  if (report_.told_phase != TrajectoryPhase::kTelling && report_.told_phase != TrajectoryPhase::kChecking) return;
  draft_->refuse("it was stopped before it began");
  refuse(draft_->why());
}

RtStatus JointTrajectory::control_loop(double time, double /*period*/) {
  before_ = now_;
  now_ = time;
  if (report_.told_phase == TrajectoryPhase::kChecking) check();
  if (moves_) move();
  if (report_.phase == TrajectoryPhase::kSettling) settle();
  for (std::size_t i = 0; i < joints_.size(); ++i) joints_[i]->setPositionReference(references_[i].position);
  report();
  return RtStatus::ok();
}

void JointTrajectory::report() noexcept {
  report_.seconds = seconds();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const auto index = static_cast<std::size_t>(joints_[i]->index());
    report_.positions[index] = references_[i].position;
    report_.velocities[index] = references_[i].velocity;
    report_.accelerations[index] = references_[i].acceleration;
  }
  reports_.write(report_);
}

bool JointTrajectory::on_command(std::string_view words) {
  std::uint64_t tag = 0;
  bool is_good = takeTag(words, tag) || object("a tag is `@` and a number above 0");
  while (is_good && !words.empty()) {
    const std::size_t length = std::min(words.find(';'), words.size());
    is_good = obey(tag, words.substr(0, length));
    words.remove_prefix(std::min(length + 1, words.size()));
  }
  report();
  return is_good;
}

bool JointTrajectory::obey(std::uint64_t tag, std::string_view words) noexcept {
  const std::string_view verb = takeWord(words);
  if (verb == "stop") return stop(tag);
  if (verb == "begin") return begin(tag);
  if (!draft_->isOpen()) return object("a trajectory starts with `begin`");
  if (tag != report_.told) return object("another client tells a trajectory at the same time: begin anew");
  const TrajectoryPhase refused = verb == "joints" ? TrajectoryPhase::kBadJoints : TrajectoryPhase::kRefused;
  return order(verb, words) || refuse(draft_->why(), refused);
}

bool JointTrajectory::begin(std::uint64_t tag) noexcept {
  enter(moves_ ? TrajectoryState::kMoving : TrajectoryState::kReading);
  report_.told = tag;
  report_.told_phase = TrajectoryPhase::kTelling;
  draft_->begin();
  return true;
}

bool JointTrajectory::stop(std::uint64_t tag) noexcept {
  if (tag == 0 || tag == report_.told) giveUp();
  if (tag == 0 || tag == report_.followed) stop();
  return true;
}

bool JointTrajectory::order(std::string_view verb, std::string_view words) noexcept {
  if (verb == "joints") return addNames(words);
  if (verb == "positions") return addNumbers(Given::kPositions, words);
  if (verb == "velocities") return addNumbers(Given::kVelocities, words);
  if (verb == "accelerations") return addNumbers(Given::kAccelerations, words);
  if (verb == "run") return run();
  double number = 0;
  if (readNumbers(takeWord(words), &number, 1) != 1)
    return draft_->refuse("`", verb, "` is followed by a number, or is no word of a trajectory");
  if (verb == "path") return draft_->allow(&Tolerance::path, number, words);
  if (verb == "goal") return draft_->allow(&Tolerance::goal, number, words);
  if (!words.empty()) return draft_->refuse("`", verb, "` is followed by one number, not also by ", words);
  if (verb == "point") return draft_->addPoint(number);
  if (verb == "speed") return draft_->setSpeed(number);
  if (verb == "velocity") return draft_->setVelocity(number);
  if (verb == "patience") return draft_->setGoalTime(number);
  return draft_->refuse("`", verb, "` is no word of a trajectory");
}

bool JointTrajectory::addNames(std::string_view words) noexcept {
  for (std::string_view name = takeWord(words); !name.empty(); name = takeWord(words)) {
    if (!draft_->addJoint(name)) return false;
  }
  return true;
}

bool JointTrajectory::addNumbers(Given kind, std::string_view words) noexcept {
  std::array<double, kMostNumbers> numbers{};
  const int count = readNumbers(words, numbers.data(), kMostNumbers);
  if (count < 0) return draft_->refuse("a point has what is no number: ", words.substr(0, 60));
  return draft_->addValues(kind, std::span(numbers).first(static_cast<std::size_t>(count)));
}

bool JointTrajectory::run() noexcept {
  if (!runs_) return draft_->refuse("this plugin is stopped: start it first");
  if (!draft_->end()) return false;
  report_.told_phase = TrajectoryPhase::kChecking;
  enter(TrajectoryState::kChecking);
  return true;
}

// To words that belong to no trajectory: that which another client tells is as it was.
bool JointTrajectory::object(std::string_view why) noexcept {
  why_.assign(why);
  enter(TrajectoryState::kRefused);
  return false;
}

// What it does meanwhile it goes on to do.
bool JointTrajectory::refuse(std::string_view why, TrajectoryPhase phase) noexcept {
  report_.told_phase = phase;
  assign(report_.refusal, why);
  return object(why);
}

void JointTrajectory::check() noexcept {
  const TrajectoryDraft::Checked checked = draft_->check();
  if (checked == TrajectoryDraft::Checked::kRefused) refuse(draft_->why());
  if (checked == TrajectoryDraft::Checked::kGood) launch();
}

// From the references, so that neither place nor velocity jumps.
void JointTrajectory::launch() noexcept {
  JointPath& next = draft_->path();
  for (std::size_t place = 0; place < next.joints().size(); ++place) {
    next.start(place) = references_[next.joints()[place]];
    Knot& first = next.knot(0, place);
    if (next.time(0) > 0) continue;
    if (std::abs(first.position - next.start(place).position) >
        std::max(defaults_.joint.goal, draft_->tolerances()[place].goal)) {
      draft_->refuse("it starts at once with ", joints_[next.joints()[place]]->name(), " at ", first.position,
                     ", which is at ", next.start(place).position,
                     ": go there first, or give the first point some time");
      refuse(draft_->why());
      return;
    }
    first.position = next.start(place).position;
  }
  if (next.time(0) > 0 && !draft_->checkStart()) {
    refuse(draft_->why());
    return;
  }
  if (!takesOver(next)) {
    refuse(draft_->why(), TrajectoryPhase::kBadJoints);
    return;
  }
  std::swap(*path_, next);
  std::swap(tolerances_, draft_->tolerances());
  goal_time_ = draft_->goalTime();
  report_.followed = report_.told;
  report_.phase = report_.told_phase = TrajectoryPhase::kMoving;
  begun_ = before_;  // the references are those of the last cycle
  moves_ = true;
  after_ = TrajectoryState::kDone;
  enter(TrajectoryState::kMoving);
}

// A joint that moves cannot be left behind: it would stop at once.
bool JointTrajectory::takesOver(const JointPath& next) noexcept {
  if (!moves_) return true;
  for (const std::size_t joint : path_->joints()) {
    const auto named = next.joints();
    if (references_[joint].velocity != 0 && std::find(named.begin(), named.end(), joint) == named.end())
      return draft_->refuse("it leaves out ", joints_[joint]->name(), ", which is moving: name it, too");
  }
  return true;
}

void JointTrajectory::move() noexcept {
  const double time = seconds();
  for (std::size_t place = 0; place < path_->joints().size(); ++place)
    references_[path_->joints()[place]] = path_->at(time, place);
  double away = 0;
  const Joint* lost = after_ == TrajectoryState::kDone ? astray(&Tolerance::path, away) : nullptr;
  if (lost != nullptr) {
    abort(*lost, away, TrajectoryPhase::kOffPath);
  } else if (time >= path_->duration()) {
    moves_ = false;
    if (after_ == TrajectoryState::kDone) report_.phase = TrajectoryPhase::kSettling;
    if (state_ == TrajectoryState::kMoving)
      enter(after_ == TrajectoryState::kDone ? TrajectoryState::kSettling : after_);
  }
}

void JointTrajectory::settle() noexcept {
  double away = 0;
  const Joint* lost = astray(&Tolerance::goal, away);
  if (lost == nullptr) {
    report_.phase = TrajectoryPhase::kDone;
    if (state_ == TrajectoryState::kSettling) enter(TrajectoryState::kDone);
  } else if (seconds() > path_->duration() + goal_time_) {
    abort(*lost, away, TrajectoryPhase::kOffGoal);
  }
}

// The joint that is farthest from its reference of those that are too far.
const Joint* JointTrajectory::astray(double Tolerance::*which, double& away) const noexcept {
  const Joint* worst = nullptr;
  away = 0;
  for (std::size_t place = 0; place < path_->joints().size(); ++place) {
    const std::size_t index = path_->joints()[place];
    const double tolerance = tolerances_[place].*which;
    const double distance = std::abs(joints_[index]->getJointPosition() - references_[index].position);
    if (tolerance > 0 && !(distance <= tolerance) && !(distance <= away)) {
      worst = joints_[index];
      away = distance;
    }
  }
  return worst;
}

void JointTrajectory::abort(const Joint& joint, double away, TrajectoryPhase why) noexcept {
  std::array<char, 32> room{};
  why_.assign(joint.name()).append(" is ").append(textOf(away, room));
  why_.append(why == TrajectoryPhase::kOffPath ? " from its path" : " from its goal");
  report_.phase = why;
  assign(report_.ending, why_.view());
  comeToRest();
  after_ = TrajectoryState::kAborted;
  enter(TrajectoryState::kAborted);
}

void JointTrajectory::stop() noexcept {
  if (report_.phase != TrajectoryPhase::kMoving && report_.phase != TrajectoryPhase::kSettling) return;
  if (moves_) comeToRest();
  report_.phase = TrajectoryPhase::kStopped;
  assign(report_.ending, "it was stopped");
  after_ = TrajectoryState::kStopped;
  enter(TrajectoryState::kStopped);
}

// On a way of its own, from where the references are.
void JointTrajectory::comeToRest() noexcept {
  path_->addPointAlone(kToRest);
  for (std::size_t place = 0; place < path_->joints().size(); ++place) {
    const std::size_t index = path_->joints()[place];
    const config::JointDescription& joint = joints_[index]->description();
    const double end = references_[index].position + references_[index].velocity * kToRest / 2;
    path_->start(place) = references_[index];
    path_->knot(0, place) = {std::clamp(end, joint.lower, joint.upper), 0, 0};
  }
  begun_ = now_;
  moves_ = true;
}

void JointTrajectory::enter(TrajectoryState state) noexcept {
  state_ = state;
  status_.assign(wordOf(state));
  const bool has_reason = state == TrajectoryState::kRefused || state == TrajectoryState::kAborted;
  if (has_reason) status_.append(": ").append(why_.view());
}

}  // namespace robotui::rt::plugins
