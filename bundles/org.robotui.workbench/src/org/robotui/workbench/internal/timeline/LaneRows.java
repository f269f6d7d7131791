package org.robotui.workbench.internal.timeline;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.replay.Timeline.LaneId;
import org.robotui.api.replay.Track;
import org.robotui.workbench.internal.timeline.LaneDensity.TrackLane;

/**
 * The rows of the recordings: one for each recording, and below it its topics where its robot is not folded.
 *
 * @param rows from top to bottom
 */
record LaneRows(List<Row> rows) {
  /** The height of a row, points. */
  static final int HEIGHT = 22;

  LaneRows {
    rows = List.copyOf(rows);
  }

  /** A row. */
  sealed interface Row {
    /** The recording that it belongs to. */
    Track track();

    /** A recording. */
    record Head(Track track, boolean folded) implements Row {}

    /** One of its topics. */
    record Topic(TrackLane of) implements Row {
      @Override
      public Track track() {
        return of.track();
      }

      LaneId id() {
        return new LaneId(track().id(), of.lane().topic());
      }
    }
  }

  static LaneRows of(List<Track> tracks, Set<String> foldedRobots) {
    List<Row> rows = new ArrayList<>();
    for (Track track : tracks) {
      boolean folded = foldedRobots.contains(track.id().robot());
      rows.add(new Row.Head(track, folded));
      if (!folded) {
        track.lanes().forEach(lane -> rows.add(new Row.Topic(new TrackLane(track, lane))));
      }
    }
    return new LaneRows(rows);
  }

  int height() {
    return rows.size() * HEIGHT;
  }

  /** The row at a distance from the top of the first. */
  Optional<Row> at(int y) {
    return y < 0 || y >= height() ? Optional.empty() : Optional.of(rows.get(y / HEIGHT));
  }

  Optional<Row> row(int index) {
    return index < 0 || index >= rows.size() ? Optional.empty() : Optional.of(rows.get(index));
  }
}
