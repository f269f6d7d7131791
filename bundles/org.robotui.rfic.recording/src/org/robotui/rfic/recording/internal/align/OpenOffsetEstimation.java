package org.robotui.rfic.recording.internal.align;

import java.io.IOException;
import java.util.Optional;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.replay.OffsetEstimate;
import org.robotui.api.replay.OffsetEstimation;
import org.robotui.api.replay.TrackId;
import org.robotui.rfic.recording.internal.time.SearchableHistory;
import org.robotui.rfic.recording.internal.time.SharedTimeline;

/** Estimates offsets of recordings of the timeline. */
@Component(service = OffsetEstimation.class)
public final class OpenOffsetEstimation implements OffsetEstimation {
  private final SharedTimeline timeline;

  /**
   * Called by declarative services.
   *
   * @param timeline knows what is open
   */
  @Activate
  public OpenOffsetEstimation(@Reference SharedTimeline timeline) {
    this.timeline = timeline;
  }

  @Override
  public Optional<OffsetEstimate> estimate(TrackId reference, TrackId moved) throws IOException, InterruptedException {
    SearchableHistory kept = timeline.open(reference).history();
    long base = kept.offset();
    return OffsetFinder.offset(kept, timeline.open(moved).history())
        .map(found -> new OffsetEstimate(found.offset() + base, found.deviation(), found.basis()));
  }
}
