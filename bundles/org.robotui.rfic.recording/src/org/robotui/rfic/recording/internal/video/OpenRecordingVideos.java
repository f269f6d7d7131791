package org.robotui.rfic.recording.internal.video;

import java.io.IOException;
import java.nio.file.Path;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.replay.RecordingVideos;
import org.robotui.api.replay.TrackId;
import org.robotui.rfic.recording.internal.time.SearchableHistory;
import org.robotui.rfic.recording.internal.time.SharedTimeline;

/** Videos of recordings of the timeline. */
@Component(service = RecordingVideos.class)
public final class OpenRecordingVideos implements RecordingVideos {
  private final SharedTimeline timeline;

  /**
   * Called by declarative services.
   *
   * @param timeline knows what is open
   */
  @Activate
  public OpenRecordingVideos(@Reference SharedTimeline timeline) {
    this.timeline = timeline;
  }

  @Override
  public long write(TrackId track, String topic, Path video) throws IOException, InterruptedException {
    SearchableHistory history = timeline.open(track).history();
    String port = CameraVideo.cameras(history).stream().filter(each -> topic.equals(each) || topic.equals("/" + each))
        .findFirst().orElseThrow(() -> new IllegalArgumentException(topic + " has no pictures that can be read"));
    return CameraVideo.write(history, port, history.span(), video, CameraVideo.RATE).frames();
  }
}
