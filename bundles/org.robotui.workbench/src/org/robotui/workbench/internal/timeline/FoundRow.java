package org.robotui.workbench.internal.timeline;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.FoundEvent;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.Track;

/**
 * An event where it lies on the timeline.
 *
 * @param number in the order of time
 * @param file the name of its recording
 * @param range times of the timeline
 * @param over whether it had ended when its recording did
 * @param words what was seen
 */
record FoundRow(int number, String file, TimeRange range, boolean over, String words) {
  /** Events of the recordings that are open, by time; a recording that is moved takes its events along. */
  static List<FoundRow> of(List<FoundEvent> events, List<Track> tracks) {
    List<FoundRow> rows = new ArrayList<>();
    events.forEach(event -> track(event, tracks).ifPresent(track -> rows.add(new FoundRow(0,
        track.file().getFileName().toString(),
        new TimeRange(event.range().start() + track.offset(), event.range().end() + track.offset()), event.over(),
        event.words()))));
    rows.sort(Comparator.comparingLong(row -> row.range().start()));
    for (int i = 0; i < rows.size(); i++) {
      FoundRow row = rows.get(i);
      rows.set(i, new FoundRow(i, row.file(), row.range(), row.over(), row.words()));
    }
    return List.copyOf(rows);
  }

  private static Optional<Track> track(FoundEvent event, List<Track> tracks) {
    return tracks.stream().filter(track -> track.id().equals(event.track())).findFirst();
  }

  /** How long it lasts, in words. */
  String length() {
    String seconds = range.length() == 0 && over ? "" : TimeWords.elapsed(range.length(), 3);
    return over ? seconds : seconds + ", to the end";
  }

  Bookmark bookmark() {
    return new Bookmark(range.start(), words);
  }
}
