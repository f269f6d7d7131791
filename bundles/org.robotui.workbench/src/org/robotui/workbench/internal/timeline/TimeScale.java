package org.robotui.workbench.internal.timeline;

import org.robotui.api.replay.TimeRange;

/**
 * Which part of the time lies where on the screen.
 *
 * @param shown the part
 * @param left where it begins, points
 * @param width how wide it is, points, at least 1
 */
record TimeScale(TimeRange shown, int left, int width) {
  /** The shortest part that can be looked at: a hundred nanoseconds, which no recorder tells apart. */
  static final long LEAST = 100;

  TimeScale {
    width = Math.max(1, width);
  }

  /** Where a time lies; far outside of what is shown it is bounded, as painting needs whole numbers. */
  int x(long time) {
    double share = between(shown.start(), time) / length();
    return left + (int) Math.clamp(Math.round(share * width), -width, 2L * width);
  }

  /** The time at a place, also outside of what is shown. */
  long time(int x) {
    return shown.start() + Math.round((double) (x - left) / width * length());
  }

  /** How much time a point of the screen is. */
  long point() {
    return Math.max(1, shown.length() / width);
  }

  /** Shows less or more, with the time at a place where it is; at most all. */
  TimeRange zoomed(int x, double factor, TimeRange all) {
    long wanted = Math.round(length() / factor);
    long next = Math.clamp(wanted, Math.min(LEAST, all.length()), Math.max(1, all.length()));
    double share = Math.clamp((double) (x - left) / width, 0, 1);
    return within(time(x) - Math.round(share * next), next, all);
  }

  /** Shows what lies some points further, as far as there is something. */
  TimeRange panned(int points, TimeRange all) {
    return within(shown.start() + Math.round((double) points / width * length()), shown.length(), all);
  }

  /** The same page where a time is in it, else the one that begins shortly before it. */
  TimeRange paged(long time, TimeRange all) {
    boolean seen = time >= shown.start() && time <= shown.end();
    return seen ? shown : within(time - shown.length() / 10, shown.length(), all);
  }

  /** How long it is from one time to another: exact where it is short, as a double does not hold such times exactly. */
  static double between(long from, long to) {
    long length = to - from;
    boolean over = ((to ^ from) & (to ^ length)) < 0;
    return over ? (double) to - from : length;
  }

  private static TimeRange within(long start, long length, TimeRange all) {
    long latest = Math.max(all.start(), all.end() - length);
    long from = Math.clamp(start, all.start(), latest);
    return new TimeRange(from, Math.min(all.end(), from + length));
  }

  private double length() {
    return Math.max(1, shown.length());
  }
}
