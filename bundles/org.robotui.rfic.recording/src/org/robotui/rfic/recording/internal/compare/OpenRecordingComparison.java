package org.robotui.rfic.recording.internal.compare;

import java.io.IOException;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.replay.ComparisonReport;
import org.robotui.api.replay.ComparisonWish;
import org.robotui.api.replay.RecordingComparison;
import org.robotui.api.replay.TrackId;
import org.robotui.rfic.recording.internal.compare.CompareWish.Pairing;
import org.robotui.rfic.recording.internal.time.PlayedTrack;
import org.robotui.rfic.recording.internal.time.SearchableHistory;
import org.robotui.rfic.recording.internal.time.SharedTimeline;

/** Compares recordings of the timeline. */
@Component(service = RecordingComparison.class)
public final class OpenRecordingComparison implements RecordingComparison {
  private final SharedTimeline timeline;

  /**
   * Called by declarative services.
   *
   * @param timeline knows what is open
   */
  @Activate
  public OpenRecordingComparison(@Reference SharedTimeline timeline) {
    this.timeline = timeline;
  }

  @Override
  public ComparisonReport compare(ComparisonWish wish) throws IOException, InterruptedException {
    CompareWish read = new CompareWish(ComparedTopic.of(wish.topic()), pairing(wish.pairing()),
        PoseFit.valueOf(wish.alignment().name()), RelativeStep.POSE, CompareWish.MOST_APART, 0);
    try {
      ComparedFile first = file(wish.first());
      return new RunComparison(first, file(wish.second()), read).run().report(first.offset());
    } catch (CompareException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  private static Pairing pairing(ComparisonWish.Pairing word) {
    return switch (word) {
      case TIME -> new Pairing.Clock();
      case START -> new Pairing.Start();
      case WAY -> Pairing.Gone.SAME;
    };
  }

  private ComparedFile file(TrackId wanted) {
    PlayedTrack track = timeline.open(wanted);
    SearchableHistory history = track.history();
    return new ComparedFile(track.file().getFileName().toString(), history, history.span(), history.offset());
  }
}
