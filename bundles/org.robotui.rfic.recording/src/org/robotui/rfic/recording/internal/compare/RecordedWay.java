package org.robotui.rfic.recording.internal.compare;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.geometry.RigidTransform;

/** The way that something went: poses by their times. Immutable. */
final class RecordedWay {
  private final long[] times;
  private final List<RigidTransform> poses;
  private final double[] gone;

  /** Times rise. */
  RecordedWay(long[] times, List<RigidTransform> poses) {
    this.times = times.clone();
    this.poses = List.copyOf(poses);
    this.gone = new double[times.length];
    for (int i = 1; i < times.length; i++) {
      gone[i] = gone[i - 1] + poses.get(i).translation().minus(poses.get(i - 1).translation()).norm();
    }
  }

  int size() {
    return times.length;
  }

  long time(int place) {
    return times[place];
  }

  RigidTransform pose(int place) {
    return poses.get(place);
  }

  /** How far it has gone when it is at a place, in metres. */
  double gone(int place) {
    return gone[place];
  }

  /** How far it has gone at a time; not a number where that is not known. */
  double goneAt(long time) {
    return SortedTimes.between(times, time, (place, part) -> part == 0 ? gone[place]
        : gone[place] + part * (gone[place + 1] - gone[place])).orElse(Double.NaN);
  }

  /** When it had gone so far for the first time; empty where it never has. */
  OptionalLong timeOf(double distance) {
    if (size() == 0 || !(distance >= 0) || distance > gone[size() - 1]) {
      return OptionalLong.empty();
    }
    int place = Arrays.binarySearch(gone, distance);
    if (place >= 0) {
      while (place > 0 && gone[place - 1] == distance) {
        place--;
      }
      return OptionalLong.of(times[place]);
    }
    int before = -place - 2;
    double part = (distance - gone[before]) / (gone[before + 1] - gone[before]);
    return OptionalLong.of(times[before] + Math.round(part * (times[before + 1] - times[before])));
  }

  /** Where it was at a time, between the poses before and after it. */
  Optional<RigidTransform> at(long time) {
    return SortedTimes.between(times, time, (place, part) -> part == 0 ? pose(place)
        : pose(place).interpolate(pose(place + 1), part));
  }

  /** The place of the pose that is nearest to a time; there is one. */
  int nearest(long time) {
    return SortedTimes.nearest(times, time);
  }
}
