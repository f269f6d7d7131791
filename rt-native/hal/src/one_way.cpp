#include "one_way.h"

#include <algorithm>

namespace robotui::rt::hal {

namespace {

bool has(const Reference& reference, std::uint8_t bits) noexcept { return (reference.mode & bits) != 0; }

double impedance(const Reference& reference, const JointSample& measured) noexcept {
  double effort = has(reference, link::kEffort) ? reference.effort : 0;
  if (has(reference, link::kPosition) && has(reference, link::kStiffness))
    effort += reference.stiffness * (reference.position - measured.position);
  const double velocity = has(reference, link::kVelocity) ? reference.velocity : 0;
  if (has(reference, link::kDamping)) effort += reference.damping * (velocity - measured.velocity);
  return effort;
}

}  // namespace

Command commandOf(const Reference& reference, const JointSample& measured, bool takes_effort,
                  double most_effort) noexcept {
  const bool by_effort = has(reference, link::kEffort) && !has(reference, link::kPosition | link::kVelocity);
  if (by_effort || (has(reference, link::kImpedance) && takes_effort))
    return {Way::kEffort, std::clamp(impedance(reference, measured), -most_effort, most_effort)};
  if (has(reference, link::kPosition)) return {Way::kPosition, reference.position};
  if (has(reference, link::kVelocity)) return {Way::kVelocity, reference.velocity};
  return {Way::kNone, 0};
}

}  // namespace robotui::rt::hal
