// Vectors over joints: the same for a chain and the whole robot.
#pragma once

#include <cassert>

#include <Eigen/Dense>

namespace robotui::rt {

template <typename Joints, typename Get>
void gather(const Joints& joints, Eigen::Ref<Eigen::VectorXd> into, Get get) noexcept {
  assert(static_cast<std::size_t>(into.size()) == joints.size());
  Eigen::Index i = 0;
  for (const auto& joint : joints) into[i++] = get(joint);
}

template <typename Joints, typename Set>
void scatter(Joints& joints, const Eigen::Ref<const Eigen::VectorXd>& from, Set set) noexcept {
  assert(static_cast<std::size_t>(from.size()) == joints.size());
  Eigen::Index i = 0;
  for (auto& joint : joints) set(joint, from[i++]);
}

}  // namespace robotui::rt
