#include "mujoco_pushes.h"

#include <algorithm>
#include <cmath>

namespace robotui::rt::hal {

std::string MujocoPushes::take(const link::Push& push, const MujocoWorld& world, double period) {
  Acting acting;
  acting.number = push.number;
  acting.cycles = static_cast<std::uint64_t>(std::llround(push.seconds / period));
  acting.force = push.force;
  if (push.joint) {
    if (*push.joint >= world.joints.size()) return "The simulation has no joint of this number.";
    acting.dof = world.joints[*push.joint].dof;
  } else {
    const auto link = world.links.find(push.link);
    if (link == world.links.end()) return "The robot has no joint and no link '" + push.link + "'.";
    if (link->second.is_fixed) return "The link " + push.link + " is fixed to the world: nothing moves it.";
    acting.body = link->second.body;
    acting.at = link->second.at;
  }
  return taken_.push(acting) ? "" : "Too many pushes come at once.";
}

void MujocoPushes::begin() noexcept {
  for (Acting& acting : acting_) {
    if (acting.cycles > 0) --acting.cycles;
  }
  for (Acting next; taken_.pop(next);) acting_[next.number % link::kMostPushes] = next;
}

void MujocoPushes::apply(const mjModel& model, mjData& data) noexcept {
  const bool acts = std::any_of(acting_.begin(), acting_.end(), [](const Acting& acting) { return acting.cycles > 0; });
  if (!acts && !acted_) return;
  mju_zero(data.qfrc_applied, model.nv);
  mju_zero(data.xfrc_applied, 6 * model.nbody);
  for (const Acting& acting : acting_) {
    if (acting.cycles > 0) add(acting, data);
  }
  acted_ = acts;
}

// MuJoCo takes the force at the center of mass: what acts beside of it turns, too.
void MujocoPushes::add(const Acting& acting, mjData& data) noexcept {
  if (acting.dof >= 0) {
    data.qfrc_applied[acting.dof] += acting.force[0];
    return;
  }
  mjtNum arm[3];
  mjtNum torque[3];
  mju_mulMatVec3(arm, data.xmat + 9 * acting.body, acting.at.data());
  mju_addTo3(arm, data.xpos + 3 * acting.body);
  mju_subFrom3(arm, data.xipos + 3 * acting.body);
  mju_cross(torque, arm, acting.force.data());
  mju_addTo3(data.xfrc_applied + 6 * acting.body, acting.force.data());
  mju_addTo3(data.xfrc_applied + 6 * acting.body + 3, torque);
}

}  // namespace robotui::rt::hal
