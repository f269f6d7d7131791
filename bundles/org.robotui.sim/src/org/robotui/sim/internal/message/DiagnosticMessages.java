package org.robotui.sim.internal.message;

import java.util.List;
import java.util.Locale;
import org.robotui.message.ros.diagnostic_msgs.DiagnosticArray;
import org.robotui.message.ros.diagnostic_msgs.DiagnosticStatus;
import org.robotui.message.ros.diagnostic_msgs.KeyValue;
import org.robotui.sim.internal.RobotState;

/** How the parts of the robot are. */
final class DiagnosticMessages {
  private static final double LOW = 0.2;
  private final String name;

  /** @param name of the robot, which stands before that of each part */
  DiagnosticMessages(String name) {
    this.name = name;
  }

  DiagnosticArray all(RobotState state, double scanRate, Stamp stamp) {
    return new DiagnosticArray(
        stamp.header(""),
        List.of(motors(state), battery(state), laser(scanRate), localisation(state), bumper(state)));
  }

  private DiagnosticStatus status(int level, String part, String message, KeyValue... values) {
    return new DiagnosticStatus(level, name + ": " + part, message, part, List.of(values));
  }

  private static KeyValue value(String key, String format, double number) {
    return new KeyValue(key, String.format(Locale.ROOT, format, number));
  }

  private DiagnosticStatus motors(RobotState state) {
    int level = state.motorsOn() ? DiagnosticStatus.OK : DiagnosticStatus.WARN;
    return status(level, "motors", state.motorsOn() ? "on" : "switched off",
        value("linear speed (m/s)", "%.2f", state.speed().linear()),
        value("angular speed (rad/s)", "%.2f", state.speed().angular()));
  }

  private DiagnosticStatus battery(RobotState state) {
    double level = state.battery().level();
    KeyValue[] values = {
        value("charge (%)", "%.1f", 100 * level),
        value("voltage (V)", "%.2f", state.battery().voltage()),
        value("current (A)", "%.2f", state.battery().current())
    };
    if (level <= 0) {
      return status(DiagnosticStatus.ERROR, "battery", "empty, motors off", values);
    }
    if (level < LOW) {
      return status(DiagnosticStatus.WARN, "battery", "low", values);
    }
    return status(DiagnosticStatus.OK, "battery", state.battery().charging() ? "charging" : "ok", values);
  }

  private DiagnosticStatus laser(double scanRate) {
    return status(DiagnosticStatus.OK, "laser", "ok", value("scan rate (Hz)", "%.1f", scanRate));
  }

  private DiagnosticStatus localisation(RobotState state) {
    int level = state.lost() ? DiagnosticStatus.WARN : DiagnosticStatus.OK;
    return status(level, "localisation", state.lost() ? "lost: set an initial pose" : "ok",
        value("x (m)", "%.2f", state.estimate().x()),
        value("y (m)", "%.2f", state.estimate().y()));
  }

  private DiagnosticStatus bumper(RobotState state) {
    int level = state.bumped() ? DiagnosticStatus.WARN : DiagnosticStatus.OK;
    return status(level, "bumper", state.bumped() ? "contact" : "no contact");
  }
}
