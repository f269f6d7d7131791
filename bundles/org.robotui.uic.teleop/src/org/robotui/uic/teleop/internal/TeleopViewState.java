package org.robotui.uic.teleop.internal;

import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.ui.Figures;

/**
 * All that the view shows, at one moment.
 *
 * @param robot who is driven
 * @param held whether a hand holds on
 * @param stick where it holds
 * @param commanded the speed sent
 * @param measured the speed that the robot reports, where it does
 * @param limits full stick; they do not hold for navigation
 * @param lease who drives
 * @param stoppedBy who latched the stop, as users read it
 * @param asking true while the user is asked whether to take over
 * @param refusal why the last command was refused
 * @param navigates whether navigation drives to a goal
 * @param output whether there is somebody to command
 * @param pad how it stands with the gamepad, empty where none is wanted
 */
record TeleopViewState(
    String robot,
    boolean held,
    Stick stick,
    Speed commanded,
    Optional<Speed> measured,
    Limits limits,
    Lease lease,
    Optional<String> stoppedBy,
    boolean asking,
    Optional<String> refusal,
    boolean navigates,
    InputState output,
    String pad) {
  /** Who drives. */
  sealed interface Lease {
    /** Nobody. */
    record Free() implements Lease {}

    /** The user of this view. */
    record Mine() implements Lease {}

    /** Somebody else. */
    record Other(String name) implements Lease {}
  }

  /** What stands at the right of the view's title. */
  String note() {
    String who = switch (lease) {
      case Lease.Free f -> "free";
      case Lease.Mine m -> "you";
      case Lease.Other o -> o.name();
    };
    return "control: " + who + " \u00b7 by hand max " + Figures.of(limits.linear(), 2, "m/s")
        + (pad.isEmpty() ? "" : " \u00b7 " + pad);
  }
}
