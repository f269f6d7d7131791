package org.robotui.workbench.internal.timeline;

import java.util.List;
import org.robotui.api.replay.Lane;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Track;

/**
 * How many messages lie where, of one lane or of several. A part is one of the equally long times for which a lane
 * knows a count.
 */
final class LaneDensity {
  private LaneDensity() {}

  /** What is known of a time: the parts that it touches, and how many messages are in them. */
  record Counted(TimeRange parts, long messages) {}

  /**
   * Messages by columns of the screen; where a column is less than a part, it has its share of it.
   *
   * @param lanes of which tracks
   * @param scale what is shown, a column for each point
   */
  static double[] columns(List<TrackLane> lanes, TimeScale scale) {
    double[] columns = new double[scale.width()];
    lanes.forEach(lane -> add(lane, scale, columns));
    return columns;
  }

  private static void add(TrackLane of, TimeScale scale, double[] columns) {
    List<Integer> counts = of.lane().density();
    TimeRange span = of.track().span();
    for (int i = 0; i < counts.size(); i++) {
      if (counts.get(i) > 0) {
        double from = column(scale, edge(span, i, counts.size()));
        double to = column(scale, edge(span, i + 1, counts.size()));
        spread(columns, from, Math.max(to, from + 1e-3), counts.get(i));
      }
    }
  }

  private static void spread(double[] columns, double from, double to, int count) {
    int last = Math.min(columns.length - 1, (int) Math.floor(to));
    for (int column = Math.max(0, (int) Math.floor(from)); column <= last; column++) {
      double common = Math.min(to, column + 1) - Math.max(from, column);
      columns[column] += Math.max(0, common) / (to - from) * count;
    }
  }

  /** Of the parts of a lane that a time touches; none where nothing is known, or the time is outside. */
  static Counted count(TrackLane of, TimeRange asked) {
    TimeRange span = of.track().span();
    List<Integer> counts = of.lane().density();
    if (counts.isEmpty() || asked.end() < span.start() || asked.start() > span.end()) {
      return new Counted(asked, 0);
    }
    int first = part(span, asked.start(), counts.size());
    int last = part(span, asked.end(), counts.size());
    long messages = counts.subList(first, last + 1).stream().mapToLong(Integer::longValue).sum();
    return new Counted(new TimeRange(edge(span, first, counts.size()), edge(span, last + 1, counts.size())), messages);
  }

  /** The same of several lanes, over all of their parts. */
  static Counted count(List<TrackLane> lanes, TimeRange asked) {
    return lanes.stream().map(lane -> count(lane, asked))
        .reduce((a, b) -> new Counted(a.parts().with(b.parts()), a.messages() + b.messages()))
        .orElse(new Counted(asked, 0));
  }

  private static int part(TimeRange span, long time, int parts) {
    double share = TimeScale.between(span.start(), time) / Math.max(1, span.length());
    return Math.clamp((long) Math.floor(share * parts), 0, parts - 1);
  }

  private static long edge(TimeRange span, int part, int parts) {
    return span.start() + Math.round((double) span.length() * part / parts);
  }

  private static double column(TimeScale scale, long time) {
    double share = TimeScale.between(scale.shown().start(), time) / Math.max(1, scale.shown().length());
    return share * scale.width();
  }

  /** A lane, with the recording that it is of. */
  record TrackLane(Track track, Lane lane) {
    static List<TrackLane> all(List<Track> tracks) {
      return tracks.stream().flatMap(t -> t.lanes().stream().map(lane -> new TrackLane(t, lane))).toList();
    }
  }
}
