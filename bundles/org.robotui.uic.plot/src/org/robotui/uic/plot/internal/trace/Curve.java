package org.robotui.uic.plot.internal.trace;

import java.util.Arrays;
import java.util.Optional;

/**
 * The points of one trace over another one, in the order of time, in bounded memory. Where one of the two is no finite
 * number, both have a break. What is asked costs as much as a screen can show, as far as the curve is smooth. Safe for
 * all threads.
 */
public final class Curve {
  private static final double NEAR = 0.7;

  private final Series x;
  private final Series y;

  /** Keeps at least so many points. */
  public Curve(long samples) {
    x = new Series(samples);
    y = new Series(samples);
  }

  /** A point, with the time at which it was. */
  public record At(long time, double x, double y) {}

  /** Adds a point; its time is not before that of the newest. */
  public synchronized void add(long time, double atX, double atY) {
    boolean there = Double.isFinite(atX) && Double.isFinite(atY);
    if (there || isWhole()) {
      x.add(time, there ? atX : Double.NaN);
      y.add(time, there ? atY : Double.NaN);
    }
  }

  /** Whether the newest sample is a point; one break is as good as many. */
  private boolean isWhole() {
    int size = y.size();
    return size > 0 && Double.isFinite(y.value(size - 1));
  }

  public synchronized void clear() {
    x.clear();
    y.clear();
  }

  /** What lies along the horizontal scale. Only read it. */
  public Series x() {
    return x;
  }

  /** What lies along the vertical scale. Only read it. */
  public Series y() {
    return y;
  }

  /** Both as they are at one moment: as many samples each, with the same times. */
  public synchronized Both samples() {
    return new Both(x.samples(), y.samples());
  }

  /** The samples of both. */
  public record Both(Samples x, Samples y) {}

  /** The point nearest to a time within a distance; breaks do not count. */
  public synchronized Optional<At> nearest(long time, long within) {
    return y.nearest(time, within).flatMap(found -> at(found.time()));
  }

  /** The newest point at or before a time. */
  public synchronized Optional<At> lastUntil(long time) {
    return y.lastUntil(time).flatMap(found -> at(found.time()));
  }

  private Optional<At> at(long time) {
    for (int i = y.indexOf(time); i < y.size() && y.time(i) == time; i++) {
      if (Double.isFinite(y.value(i))) {
        return Optional.of(new At(time, x.value(i), y.value(i)));
      }
    }
    return Optional.empty();
  }

  /**
   * Draws what lies within a span of time for a screen. Points that a screen does not tell apart become one; where
   * there are too many others, those furthest to each side are kept of so many in a row.
   *
   * @param fineness how much of each scale a point of the screen shows
   * @param sketch is cleared and filled
   */
  public synchronized void sketch(TimeSpan span, Fineness fineness, CurveSketch sketch) {
    sketch.clear();
    int from = y.indexOf(span.from());
    int to = y.indexOf(span.to() + 1);
    if (from < to) {
      walk(from, to, new Walk(fineness, Math.ceilDiv(to - from, CurveSketch.MOST_RUNS), sketch));
      put(to - 1, sketch);
    }
  }

  /** What one point of the screen shows of each scale. */
  public record Fineness(double x, double y) {}

  private record Walk(Fineness fineness, int least, CurveSketch sketch) {}

  private void walk(int from, int to, Walk walk) {
    if (to - from == 1 || isPoint(from, to, walk.fineness)) {
      put(from, walk.sketch);
    } else if (to - from <= walk.least) {
      walk.sketch.dense();
      furthest(from, to, walk.sketch);
    } else {
      // The boundary inside that is a multiple of the largest power of two: what scrolls is divided the same.
      int middle = to - 1 & -Integer.highestOneBit(from ^ to - 1);
      walk(from, middle, walk);
      walk(middle, to, walk);
    }
  }

  /** Whether a screen shows no more than a point of them; what has a break is none. */
  private boolean isPoint(int from, int to, Fineness fineness) {
    return isNarrow(y, from, to, fineness.y) && isNarrow(x, from, to, fineness.x);
  }

  private static boolean isNarrow(Series series, int from, int to, double fine) {
    Summary all = new Summary();
    series.summarize(from, to, all);
    return all.count() == to - from && all.max() - all.min() <= fine * NEAR;
  }

  private void furthest(int from, int to, CurveSketch sketch) {
    int[] at = {-1, -1, -1, -1};
    int numbers = 0;
    for (int i = from; i < to; i++) {
      if (Double.isFinite(y.value(i))) {
        at[0] = at[0] < 0 || x.value(i) < x.value(at[0]) ? i : at[0];
        at[1] = at[1] < 0 || x.value(i) > x.value(at[1]) ? i : at[1];
        at[2] = at[2] < 0 || y.value(i) < y.value(at[2]) ? i : at[2];
        at[3] = at[3] < 0 || y.value(i) > y.value(at[3]) ? i : at[3];
        numbers++;
      }
    }
    if (numbers < to - from) {
      sketch.add(y.time(from), Double.NaN, Double.NaN);
    }
    if (numbers > 0) {
      Arrays.stream(at).sorted().distinct().forEach(i -> put(i, sketch));
    }
  }

  private void put(int index, CurveSketch sketch) {
    sketch.add(y.time(index), x.value(index), y.value(index));
  }
}
