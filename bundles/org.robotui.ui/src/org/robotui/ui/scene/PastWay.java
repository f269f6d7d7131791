package org.robotui.ui.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.replay.StreamHistory;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** The way of a robot as a recording has it. Read by one thread, asked by another. */
final class PastWay {
  private static final int DRAWN = 1000;
  /** Before the first and after the last value the robot stood there for so long, in nanoseconds. */
  private static final long BESIDE = 1_000_000_000L;

  private volatile Optional<Known> known = Optional.empty();

  private record Known(PoseSeries series, List<Vector3> drawn) {}

  /** Where the robot was, by a time of the recording; none while that is not read. */
  Optional<PastSpot> at(long time) {
    return known.filter(way -> time >= way.series.time(0) - BESIDE
        && time <= way.series.time(way.series.poses().size() - 1) + BESIDE)
        .map(way -> new PastSpot(way.series.frame(), pose(way.series, time), way.drawn));
  }

  private static RigidTransform pose(PoseSeries way, long time) {
    int before = Math.max(0, way.lastUntil(time));
    int next = Math.min(before + 1, way.poses().size() - 1);
    if (next == before || time <= way.time(before)) {
      return way.poses().get(before);
    }
    double share = (double) (time - way.time(before)) / (way.time(next) - way.time(before));
    return way.poses().get(before).interpolate(way.poses().get(next), Math.min(1, share));
  }

  /** Reads it whole. */
  void read(StreamHistory history, String port) {
    known = PoseSeries.read(history, port).map(series -> new Known(series, drawn(series.poses())));
  }

  private static List<Vector3> drawn(List<RigidTransform> poses) {
    int step = Math.max(1, poses.size() / DRAWN);
    List<Vector3> drawn = new ArrayList<>();
    for (int i = 0; i < poses.size(); i += step) {
      drawn.add(poses.get(i).translation());
    }
    return List.copyOf(drawn);
  }
}
