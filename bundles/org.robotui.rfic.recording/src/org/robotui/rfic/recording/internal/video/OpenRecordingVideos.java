package org.robotui.rfic.recording.internal.video;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.replay.PictureVideo;
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

  @Override
  public PictureVideo begin(Path video, int width, int height, double rate) throws IOException {
    if (Files.exists(video)) {
      throw new IOException(video + " is there already: name a file that is new");
    }
    FfmpegProcess process = FfmpegProcess.start(video, width, height, rate);
    return new PictureVideo() {
      @Override
      public void add(byte[] bgr, int pictureWidth, int pictureHeight) throws IOException {
        process.add(PictureFrame.of(bgr, pictureWidth, pictureHeight));
      }

      @Override
      public void finish() throws IOException, InterruptedException {
        process.finish();
      }

      @Override
      public void close() {
        process.close();
      }
    };
  }
}
