package org.robotui.uic.teleop.internal;

import java.util.Optional;

/**
 * What the hands on a gamepad want: a stick, as long as the dead-man button is held, and a stop. Pure; one thread.
 */
final class PadHands {
  private static final double FULL = 32767;
  /** Sticks of gamepads do not come back to their middle exactly. */
  private static final double DEAD_ZONE = 0.12;

  private double forward;
  private double left;
  private boolean held;

  /** What is to be done after an event. */
  enum Wish {
    NOTHING, DRIVE, LET_GO, STOP
  }

  /**
   * Takes an event. A button that was down before the device was opened counts from its next press on: nobody may hold
   * it on purpose.
   */
  Wish take(PadEvent event, PadMapping mapping) {
    if (event.button()) {
      return event.initial() ? Wish.NOTHING : button(event, mapping);
    }
    if (event.number() == mapping.forward()) {
      forward = 0.0 - share(event.value());
    } else if (event.number() == mapping.turn()) {
      left = 0.0 - share(event.value());
    }
    return held ? Wish.DRIVE : Wish.NOTHING;
  }

  private Wish button(PadEvent event, PadMapping mapping) {
    boolean down = event.value() != 0;
    if (event.number() == mapping.stop() && down) {
      return Wish.STOP;
    }
    if (event.number() != mapping.deadMan()) {
      return Wish.NOTHING;
    }
    held = down;
    return down ? Wish.DRIVE : Wish.LET_GO;
  }

  /** Where the stick is held; none without the dead-man button. */
  Optional<Stick> stick() {
    return held ? Optional.of(new Stick(forward, left)) : Optional.empty();
  }

  /** From 0 at the edge of the middle to 1, so that it begins slowly. */
  private static double share(int value) {
    double share = Math.clamp(value / FULL, -1.0, 1.0);
    double beyond = Math.max(0, Math.abs(share) - DEAD_ZONE) / (1 - DEAD_ZONE);
    return Math.copySign(beyond, share) + 0.0;
  }
}
