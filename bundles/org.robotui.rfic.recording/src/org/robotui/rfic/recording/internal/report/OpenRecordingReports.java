package org.robotui.rfic.recording.internal.report;

import java.io.IOException;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.replay.RecordingReports;
import org.robotui.api.replay.TrackId;
import org.robotui.rfic.recording.internal.time.PlayedTrack;
import org.robotui.rfic.recording.internal.time.SharedTimeline;

/** Reports of recordings of the timeline. */
@Component(service = RecordingReports.class)
public final class OpenRecordingReports implements RecordingReports {
  private final SharedTimeline timeline;

  /**
   * Called by declarative services.
   *
   * @param timeline knows what is open
   */
  @Activate
  public OpenRecordingReports(@Reference SharedTimeline timeline) {
    this.timeline = timeline;
  }

  @Override
  public String page(TrackId wanted) throws IOException, InterruptedException {
    PlayedTrack track = timeline.open(wanted);
    ReportedFile file = new ReportedFile(track.file().getFileName().toString(), track.problems());
    return ReportPage.of(file, track.history(), track.history().span());
  }
}
