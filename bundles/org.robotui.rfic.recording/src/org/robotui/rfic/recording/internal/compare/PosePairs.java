package org.robotui.rfic.recording.internal.compare;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.LongFunction;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;

/**
 * Poses of two ways that belong together.
 *
 * @param times of the first way
 * @param first its poses
 * @param second those of the other way
 */
record PosePairs(List<Long> times, List<RigidTransform> first, List<RigidTransform> second) {
  private static final int FEWEST = 2;

  private PosePairs() {
    this(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
  }

  private void add(long time, RigidTransform one, RigidTransform other) {
    times.add(time);
    first.add(one);
    second.add(other);
  }

  /** Each pose of the way with fewer poses has the nearest one of the other, where that is near enough. */
  static PosePairs nearest(RecordedWay one, RecordedWay other, long shift, long most) {
    PosePairs pairs = new PosePairs();
    boolean secondIsLonger = other.size() > one.size();
    RecordedWay few = secondIsLonger ? one : other;
    RecordedWay many = secondIsLonger ? other : one;
    long there = secondIsLonger ? -shift : shift;
    for (int i = 0; i < few.size(); i++) {
      long wanted = few.time(i) + there;
      int k = many.nearest(wanted);
      if (Math.abs(many.time(k) - wanted) <= most) {
        pairs.add(secondIsLonger ? one.time(i) : one.time(k), secondIsLonger ? one.pose(i) : one.pose(k),
            secondIsLonger ? other.pose(k) : other.pose(i));
      }
    }
    return pairs;
  }

  /** Each pose of the first way has the pose of the other at the time that belongs to it. */
  static PosePairs mapped(RecordedWay one, RecordedWay other, LongFunction<OptionalLong> mapping) {
    PosePairs pairs = new PosePairs();
    for (int i = 0; i < one.size(); i++) {
      OptionalLong there = mapping.apply(one.time(i));
      Optional<RigidTransform> pose = there.isPresent() ? other.at(there.getAsLong()) : Optional.empty();
      if (pose.isPresent()) {
        pairs.add(one.time(i), one.pose(i), pose.get());
      }
    }
    return pairs;
  }

  /** The same with the second way moved onto the first. */
  PosePairs aligned(PoseFit fit) throws CompareException {
    if (times.size() < FEWEST) {
      throw new CompareException(times.isEmpty() ? "no poses of both belong together: their times do not overlap, or"
          + " lie farther apart than --max-diff; align them by their starts, or with --offset"
          : "only one pose of both belongs together");
    }
    RigidTransform moving = fit.of(second, first);
    return new PosePairs(times, first, second.stream().map(moving::times).toList());
  }

  /** Absolute and relative errors, each of places and of turns, in metres and degrees. */
  List<ErrorSeries> errors(RelativeStep step) {
    List<ErrorSeries> all = new ArrayList<>();
    long[] at = times.stream().mapToLong(Long::longValue).toArray();
    double[] apart = new double[at.length];
    double[] turned = new double[at.length];
    for (int i = 0; i < at.length; i++) {
      apart[i] = second.get(i).translation().minus(first.get(i).translation()).norm();
      turned[i] = degrees(second.get(i).inverse().times(first.get(i)).rotation());
    }
    all.add(ErrorSeries.of("APE position", "m", at, apart));
    all.add(ErrorSeries.of("APE rotation", "deg", at, turned));
    relative(step, all);
    return all;
  }

  private void relative(RelativeStep step, List<ErrorSeries> all) {
    List<Integer> places = step.places(second);
    int count = places.size() - 1;
    if (count < 1) {
      return;
    }
    long[] at = new long[count];
    double[] apart = new double[count];
    double[] turned = new double[count];
    for (int i = 0; i < count; i++) {
      int from = places.get(i);
      int to = places.get(i + 1);
      RigidTransform one = first.get(from).inverse().times(first.get(to));
      RigidTransform error = one.inverse().times(second.get(from).inverse().times(second.get(to)));
      at[i] = times.get(to);
      apart[i] = error.translation().norm();
      turned[i] = degrees(error.rotation());
    }
    all.add(ErrorSeries.of("RPE position per " + step, "m", at, apart));
    all.add(ErrorSeries.of("RPE rotation per " + step, "deg", at, turned));
  }

  /** The angle of a turn. */
  private static double degrees(Quaternion turn) {
    double axis = Math.hypot(Math.hypot(turn.x(), turn.y()), turn.z());
    return Math.toDegrees(2 * Math.atan2(axis, Math.abs(turn.w())));
  }
}
