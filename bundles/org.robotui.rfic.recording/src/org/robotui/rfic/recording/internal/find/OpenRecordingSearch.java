package org.robotui.rfic.recording.internal.find;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.replay.FoundEvent;
import org.robotui.api.replay.RecordingSearch;
import org.robotui.api.replay.SearchReport;
import org.robotui.api.replay.SearchTaker;
import org.robotui.condition.TimedCondition;
import org.robotui.rfic.recording.internal.time.PlayedTrack;
import org.robotui.rfic.recording.internal.time.SearchableHistory;
import org.robotui.rfic.recording.internal.time.SharedTimeline;

/** Searches in the recordings of the timeline. */
@Component(service = RecordingSearch.class)
public final class OpenRecordingSearch implements RecordingSearch {
  private final SharedTimeline timeline;

  /**
   * Called by declarative services.
   *
   * @param timeline knows what is open
   */
  @Activate
  public OpenRecordingSearch(@Reference SharedTimeline timeline) {
    this.timeline = timeline;
  }

  @Override
  public Optional<String> fault(String condition) {
    try {
      TimedCondition.parse(condition, 0);
      return Optional.empty();
    } catch (IllegalArgumentException e) {
      return Optional.of(e.getMessage());
    }
  }

  @Override
  public SearchReport search(String condition, SearchTaker taker) throws IOException, InterruptedException {
    TimedCondition timed = TimedCondition.parse(condition, 0);
    List<PlayedTrack> tracks = timeline.open().stream()
        .filter(track -> !ConditionScan.sources(timed, track.history()).isEmpty()).toList();
    if (tracks.isEmpty()) {
      throw new IllegalArgumentException(SourceWords.nothing(timeline.open().stream().map(PlayedTrack::history)));
    }
    List<ScanOutcome> outcomes = new ArrayList<>();
    List<String> problems = new ArrayList<>();
    Progress progress = new Progress(taker, tracks.size());
    for (PlayedTrack track : tracks) {
      SearchableHistory history = track.history();
      // Conditions remember what they have seen: each recording has its own.
      ScanOutcome outcome = ConditionScan.run(TimedCondition.parse(condition, 0), history, history.span(),
          span -> taker.found(new FoundEvent(track.id(), span.range(), span.over(), span.words())),
          time -> progress.reached(history, time));
      outcomes.add(outcome);
      outcome.problems().forEach(each -> problems.add(track.file().getFileName() + ": " + each));
      if (progress.ended) {
        break;
      }
      progress.done++;
    }
    Optional<String> unknown = progress.ended ? Optional.empty() : ScanOutcome.neverKnown(outcomes);
    if (unknown.isPresent()) {
      throw new IllegalArgumentException(unknown.get());
    }
    return new SearchReport(outcomes.stream().mapToLong(ScanOutcome::values).sum(), problems);
  }

  /** How far all recordings are, each of the same share. One thread. */
  private static final class Progress {
    private final SearchTaker taker;
    private final int all;
    private int done;
    private boolean ended;

    private Progress(SearchTaker taker, int all) {
      this.taker = taker;
      this.all = all;
    }

    private boolean reached(SearchableHistory history, long time) {
      double part = (double) (time - history.span().start()) / Math.max(1, history.span().length());
      ended = !taker.reached((done + Math.clamp(part, 0, 1)) / all);
      return !ended;
    }
  }
}
