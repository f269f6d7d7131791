package org.robotui.workbench.internal.timeline;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.robotui.api.replay.FoundEvent;
import org.robotui.api.replay.RecordingSearch;
import org.robotui.api.replay.SearchReport;
import org.robotui.api.replay.SearchTaker;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.TrackId;

/** A search that finds what it is given, whatever is searched for. */
final class PretendSearch implements RecordingSearch {
  private static final String BAD = "bad";

  List<FoundEvent> events = List.of();
  List<String> problems = List.of();
  String breaks = "";
  boolean stopped;

  static FoundEvent event(TrackId track, double from, double to, String words) {
    return new FoundEvent(track, new TimeRange(PretendTimeline.BEGIN + Math.round(from * PretendTimeline.SECOND),
        PretendTimeline.BEGIN + Math.round(to * PretendTimeline.SECOND)), true, words);
  }

  @Override
  public Optional<String> fault(String condition) {
    return condition.startsWith(BAD) ? Optional.of("'" + condition + "' is no condition") : Optional.empty();
  }

  @Override
  public SearchReport search(String condition, SearchTaker taker) throws IOException {
    for (int i = 0; i < events.size(); i++) {
      stopped = !taker.reached((double) i / events.size());
      if (stopped) {
        return new SearchReport(i, List.of());
      }
      taker.found(events.get(i));
    }
    if (!breaks.isEmpty()) {
      throw new IOException(breaks);
    }
    taker.reached(1);
    return new SearchReport(events.size(), problems);
  }
}
