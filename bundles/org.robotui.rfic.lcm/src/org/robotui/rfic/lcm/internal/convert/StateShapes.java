package org.robotui.rfic.lcm.internal.convert;

import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robotui.data.joint.JointState;
import org.robotui.data.sensor.Battery;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.rfic.lcm.internal.language.Field;
import org.robotui.rfic.lcm.internal.language.Form;
import org.robotui.rfic.lcm.internal.language.Quantity;
import org.robotui.rfic.lcm.internal.language.Values;

/** How a robot is. */
final class StateShapes {
  private static final List<String> LEVELS = List.of("debug", "info", "warning", "error", "fatal");

  private StateShapes() {}

  static Stream<Shape<?>> all() {
    return Stream.of(
        new Shape<>(Form.of("battery", List.of("voltage | charge"),
            List.of(Field.number("voltage", Quantity.VOLTAGE, "voltage"),
                Field.number("current", Quantity.CURRENT, "current"),
                Field.number("charge", Quantity.SHARE, "level", "state_of_charge"),
                Field.flag("charging", "charging"), Field.stamp())),
            Battery.class, StateShapes::battery),
        new Shape<>(Form.of("jointstate", List.of("name"), List.of(
            Field.texts("name", "joint_name", "name", "names", "joints[].name"),
            Field.numbers("position", Quantity.JOINT, "joint_position", "position", "joints[].position"),
            Field.numbers("velocity", Quantity.JOINT_SPEED, "joint_velocity", "velocity", "joints[].velocity"),
            Field.numbers("effort", Quantity.EFFORT, "joint_effort", "effort", "joints[].effort"), Field.stamp())),
            JointState.class,
            (v, r) -> joints(v)),
        new Shape<>(
            Form.of("log", List.of("text"), List.of(Field.text("level", "level", "severity"), Field.texts("levels"),
                Field.text("text", "text", "message"), Field.text("source", "source", "name"), Field.stamp())),
            LogEntry.class, (v, r) -> log(v, r)));
  }

  private static Battery battery(Values v, Reception r) {
    Battery.Status status = !v.has("charging") ? Battery.Status.UNKNOWN
        : v.flag("charging") ? Battery.Status.CHARGING : Battery.Status.DISCHARGING;
    return new Battery(v.number("voltage", Double.NaN), v.number("current", Double.NaN), v.number("charge", Double.NaN),
        status);
  }

  private static JointState joints(Values v) {
    List<String> names = v.texts("name");
    double[] position = v.numbers("position");
    double[] velocity = v.numbers("velocity");
    double[] effort = v.numbers("effort");
    return new JointState(IntStream.range(0, names.size())
        .mapToObj(i -> new JointState.Joint(names.get(i), at(position, i), at(velocity, i), at(effort, i))).toList());
  }

  private static double at(double[] numbers, int i) {
    return i < numbers.length ? numbers[i] : Double.NaN;
  }

  private static LogEntry log(Values v, Reception r) {
    List<String> levels = v.has("levels") ? v.texts("levels") : LEVELS;
    return new LogEntry(severity(v.text("level", "info"), levels), v.text("source", r.channel()), v.text("text", ""),
        "");
  }

  private static Severity severity(String written, List<String> levels) {
    String word =
        written.matches("\\d{1,4}") ? levels.get(Math.min(Integer.parseInt(written), levels.size() - 1)) : written;
    return switch (word.toLowerCase(Locale.ROOT)) {
      case "debug", "trace" -> Severity.DEBUG;
      case "info", "notice" -> Severity.INFO;
      case "warn", "warning" -> Severity.WARNING;
      case "fatal", "critical" -> Severity.FATAL;
      default -> Severity.ERROR;
    };
  }
}
