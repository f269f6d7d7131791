package org.robotui.uic.teleop.internal;

import java.util.List;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;

/**
 * Which gamepad drives, and what its sticks and buttons do.
 *
 * @param device empty for none, {@code auto} for the first that is plugged in, else the file of a device
 * @param forward the axis that drives forward and back
 * @param turn the axis that turns
 * @param deadMan the button that must be held while it drives
 * @param stop the button that stops the robot
 */
record PadMapping(String device, int forward, int turn, int deadMan, int stop) {
  static final String DEVICE = "gamepad";
  static final String AUTO = "auto";

  private static final String FORWARD = "gamepad_forward";
  private static final String TURN = "gamepad_turn";
  private static final String DEAD_MAN = "gamepad_dead_man";
  private static final String STOP = "gamepad_stop";
  private static final ValueType NUMBER = new ValueType.Int(0, 63);

  static final List<Setting> SETTINGS = List.of(
      Setting.of(DEVICE, new ValueType.Text(
          TextRule.matching("nothing, auto, or a device such as /dev/input/js0", "|auto|/.+")), "",
          "Gamepad that drives: none, auto for the first that is plugged in, or a device of Linux."),
      Setting.of(FORWARD, NUMBER, 1L, "Axis of the gamepad that drives forward and back."),
      Setting.of(TURN, NUMBER, 0L, "Axis of the gamepad that turns."),
      Setting.of(DEAD_MAN, NUMBER, 4L, "Button of the gamepad that must be held while it drives."),
      Setting.of(STOP, NUMBER, 1L, "Button of the gamepad that stops the robot, latched."));

  static PadMapping of(Settings settings) {
    return new PadMapping(settings.text(DEVICE), axis(settings, FORWARD), axis(settings, TURN),
        axis(settings, DEAD_MAN), axis(settings, STOP));
  }

  boolean isUsed() {
    return !device.isEmpty();
  }

  private static int axis(Settings settings, String name) {
    return (int) settings.integer(name);
  }
}
