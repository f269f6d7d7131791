package org.robotui.rfic.recording.internal.align;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.data.Data;
import org.robotui.data.geometry.Twist;
import org.robotui.data.sensor.Imu;
import org.robotui.geometry.Vector3;
import org.robotui.rfic.recording.internal.time.SearchableHistory;

/** How fast a robot turned, as each of its sensors recorded it: what moves together turns together. */
final class TurningRates {
  /** More tells nothing more. */
  private static final int MOST = 500_000;
  /** Less tells of no direction, m/s2. */
  private static final double LEAST_WEIGHT = 5;
  /** Velocity commands are twists, too, but what is commanded comes before what is done. */
  private static final Set<String> MEASURED = Set.of("Odometry", "Imu", "Twist");

  /**
   * One of them.
   *
   * @param port who measured it
   * @param samples in the order of time
   */
  record Rate(String port, List<Sample> samples) {}

  /**
   * At a time.
   *
   * @param time when it was recorded
   * @param value rad/s about the axis that points up
   */
  record Sample(long time, double value) {}

  private TurningRates() {}

  static List<Rate> of(SearchableHistory history) throws IOException, InterruptedException {
    Map<String, ArrayList<Sample>> all = new LinkedHashMap<>();
    Set<String> ports = history.candidates().stream().filter(each -> MEASURED.contains(each.typeName()))
        .map(each -> each.id().port()).collect(Collectors.toSet());
    int[] count = {0};
    history.read(ports, history.span(), new HistoryTaker() {
      @Override
      public void take(RecordedValue value) {
        turning(value.value()).ifPresent(rate -> {
          count[0]++;
          all.computeIfAbsent(value.port(), port -> new ArrayList<>()).add(new Sample(value.time(), rate));
        });
      }

      @Override
      public boolean reached(long time) {
        return count[0] < MOST;
      }
    });
    return all.entrySet().stream().map(each -> new Rate(each.getKey(), each.getValue())).toList();
  }

  /** About the axis on which the weight lies: sensors are mounted as they fit. */
  private static double upright(Vector3 rate, Optional<Vector3> acceleration) {
    return acceleration.filter(each -> each.norm() > LEAST_WEIGHT).map(each -> rate.dot(each) / each.norm())
        .orElse(rate.z());
  }

  private static OptionalDouble turning(Data value) {
    return switch (value) {
      case Twist twist -> OptionalDouble.of(twist.angular().z());
      case Imu imu -> imu.angularVelocity().map(rate -> OptionalDouble.of(upright(rate, imu.linearAcceleration())))
          .orElse(OptionalDouble.empty());
      default -> OptionalDouble.empty();
    };
  }
}
