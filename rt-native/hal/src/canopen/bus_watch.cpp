#include "bus_watch.h"

#include <algorithm>

#include <linux/can/error.h>

namespace robotui::rt::hal::canopen {

// A controller that is off neither sends nor receives: whatever comes says that it is not.
void BusWatch::heard(const Frame& frame) noexcept {
  if ((frame.can_id & CAN_ERR_FLAG) == 0) {
    off_ = down_ = false;
    return;
  }
  if ((frame.can_id & CAN_ERR_BUSOFF) != 0) off_ = true;
  if ((frame.can_id & CAN_ERR_RESTARTED) != 0) off_ = false;
  if ((frame.can_id & CAN_ERR_CRTL) != 0 && (frame.data[1] & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0)
    passive_ = true;
}

bool BusWatch::sent(Sent outcome) noexcept {
  if (outcome == Sent::kYes) {
    down_ = false;
    return true;
  }
  (outcome == Sent::kDown ? down_ : had_no_room_) = true;
  return false;
}

Cause BusWatch::now() const noexcept {
  if (down_) return Cause::kBusDown;
  if (off_) return Cause::kBusOff;
  return full_ >= full_cycles_ ? Cause::kBusFull : Cause::kNone;
}

Alarm BusWatch::look() noexcept {
  full_ = had_no_room_ ? std::min(full_ + 1, full_cycles_) : 0;
  had_no_room_ = false;
  const Cause cause = now();
  if (cause != told_) {
    told_ = cause;
    return {cause == Cause::kNone ? Cause::kBusBack : cause};
  }
  if (!passive_) return {};
  passive_ = false;
  return {Cause::kBusPassive};
}

}  // namespace robotui::rt::hal::canopen
