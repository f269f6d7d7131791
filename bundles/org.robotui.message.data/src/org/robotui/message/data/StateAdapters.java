package org.robotui.message.data;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.joint.JointState;
import org.robotui.data.sensor.Battery;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.message.ros.diagnostic_msgs.DiagnosticArray;
import org.robotui.message.ros.diagnostic_msgs.DiagnosticStatus;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.rosgraph_msgs.Log;
import org.robotui.message.ros.sensor_msgs.BatteryState;
import org.robotui.message.ros.tf2_msgs.TFMessage;

/** What robots say of their own state. */
public final class StateAdapters {
  private static final int LOG_WARN = 4;
  private static final int LOG_INFO = 2;
  private static final int LOG_ERROR = 8;
  private static final int LOG_FATAL = 16;

  private StateAdapters() {}

  static List<Adapter<?, ?>> all() {
    return List.of(
        Adapter.of(BatteryState.class, Battery.class, (m, names) -> battery(m),
            m -> m.header().stamp()),
        Adapter.of(org.robotui.message.ros.sensor_msgs.JointState.class, JointState.class,
            (m, names) -> joints(m), m -> m.header().stamp()),
        Adapter.of(DiagnosticArray.class, Diagnostics.class,
            (m, names) -> diagnostics(m), m -> m.header().stamp()),
        Adapter.of(Log.class, LogEntry.class, (m, names) -> log(m), m -> m.header().stamp()),
        Adapter.of(org.robotui.message.ros.rcl_interfaces.RclLog.class, LogEntry.class, (m, names) -> log(m),
            m -> m.stamp()),
        new Adapter<>("tf2_msgs/TFMessage", new MessageForm.Bound<>(TFMessage.class, false), TransformSet.class,
            (m, names) -> transforms(m, names, false), StateAdapters::stampOf),
        new Adapter<>("tf/tfMessage", new MessageForm.Bound<>(org.robotui.message.ros.tf.TfMessage.class, false),
            TransformSet.class,
            (m, names) -> transforms(new TFMessage(m.transforms()), names, false), m -> 0));
  }

  /**
   * Transforms, in which one that is none (no rotation, not finite) is left out.
   *
   * @param m the message
   * @param names names frames of the robot
   * @param fixed true for those that never change
   * @return the transforms, or none where all were left out
   */
  public static Optional<TransformSet> transforms(TFMessage m, FrameNames names, boolean fixed) {
    List<FrameTransform> good = m.transforms().stream().flatMap(t -> transform(t, names, fixed).stream()).toList();
    return good.isEmpty() ? Optional.empty() : Optional.of(new TransformSet(good));
  }

  /**
   * Why the first transform that is left out is none.
   *
   * @param m the message
   * @param names names frames of the robot
   * @return its frames and what is wrong with it, or none where all are transforms
   */
  public static Optional<String> refusal(TFMessage m, FrameNames names) {
    for (TransformStamped t : m.transforms()) {
      try {
        converted(t, names, false);
      } catch (IllegalArgumentException e) {
        return Optional.of("'" + t.header().frameId() + "' -> '" + t.childFrameId() + "': " + e.getMessage());
      }
    }
    return Optional.empty();
  }

  private static Optional<FrameTransform> transform(TransformStamped t, FrameNames names, boolean fixed) {
    try {
      return Optional.of(converted(t, names, fixed));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  private static FrameTransform converted(TransformStamped t, FrameNames names, boolean fixed) {
    return new FrameTransform(names.frame(t.header().frameId()), names.frame(t.childFrameId()),
        names.stamp(t.header().stamp()),
        Geometry.transform(t.transform()), fixed);
  }

  private static long stampOf(TFMessage m) {
    return m.transforms().isEmpty() ? 0 : m.transforms().getFirst().header().stamp();
  }

  private static Battery battery(BatteryState m) {
    Battery.Status[] states = Battery.Status.values();
    int status = m.powerSupplyStatus();
    double charge = m.percentage() > 1 && m.percentage() <= 100 ? m.percentage() / 100 : m.percentage();
    return new Battery(m.voltage(), m.current(), charge >= 0 && charge <= 1 ? charge : Double.NaN,
        status >= 0 && status < states.length ? states[status] : Battery.Status.UNKNOWN);
  }

  private static JointState joints(org.robotui.message.ros.sensor_msgs.JointState m) {
    return new JointState(IntStream.range(0, m.name().size())
        .mapToObj(
            i -> new JointState.Joint(m.name().get(i), at(m.position(), i), at(m.velocity(), i), at(m.effort(), i)))
        .toList());
  }

  private static double at(double[] values, int index) {
    return index < values.length ? values[index] : Double.NaN;
  }

  private static Diagnostics diagnostics(DiagnosticArray m) {
    return new Diagnostics(m.status().stream().map(StateAdapters::item).toList());
  }

  private static Diagnostics.Item item(DiagnosticStatus s) {
    Map<String, String> values = new LinkedHashMap<>();
    s.values().forEach(v -> values.put(v.key(), v.value()));
    Diagnostics.Level[] levels = Diagnostics.Level.values();
    Diagnostics.Level level = s.level() >= 0 && s.level() < levels.length ? levels[s.level()] : Diagnostics.Level.ERROR;
    return new Diagnostics.Item(s.name(), s.hardwareId(), level, s.message(), values);
  }

  private static LogEntry log(Log m) {
    return new LogEntry(severity(m.level()), m.name(), m.msg(), location(m.file(), m.line()));
  }

  /** Levels of ROS 2 are tens, of which the constants are the lowest of each. */
  private static LogEntry log(org.robotui.message.ros.rcl_interfaces.RclLog m) {
    Severity[] severities =
        {Severity.DEBUG, Severity.DEBUG, Severity.INFO, Severity.WARNING, Severity.ERROR, Severity.FATAL};
    int level = Math.clamp(m.level() / org.robotui.message.ros.rcl_interfaces.RclLog.DEBUG, 0, severities.length - 1);
    return new LogEntry(severities[level], m.name(), m.msg(), location(m.file(), m.line()));
  }

  private static String location(String file, long line) {
    return file.isEmpty() ? "" : file + ":" + line;
  }

  private static Severity severity(int level) {
    if (level >= LOG_FATAL) {
      return Severity.FATAL;
    }
    if (level >= LOG_ERROR) {
      return Severity.ERROR;
    }
    return level >= LOG_WARN ? Severity.WARNING : level >= LOG_INFO ? Severity.INFO : Severity.DEBUG;
  }
}
