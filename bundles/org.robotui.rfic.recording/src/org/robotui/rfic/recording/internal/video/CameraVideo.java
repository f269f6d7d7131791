package org.robotui.rfic.recording.internal.video;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.port.Input;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.TimeRange;
import org.robotui.data.image.Image;
import org.robotui.rfic.recording.internal.time.SearchableHistory;

/**
 * Makes a video of the pictures of a camera: it takes as long as the recording did, with so many pictures a second,
 * each time the last one that had come. Its size is that of the first picture. For one thread.
 */
public final class CameraVideo implements HistoryTaker {
  /** Pictures a second, where nothing else is wanted. */
  public static final double RATE = 25;

  private static final double NANOS = 1e9;

  private final Path video;
  private final double rate;
  private Optional<FfmpegProcess> process = Optional.empty();
  private Optional<BufferedImage> last = Optional.empty();
  private Optional<IOException> failure = Optional.empty();
  private long first;
  private long frames;
  private long unreadable;

  private CameraVideo(Path video, double rate) {
    this.video = video;
    this.rate = rate;
  }

  /**
   * What came of it.
   *
   * @param frames how many pictures the video has
   * @param unreadable how many of the recording are not in it, as they cannot be read or are not of eight bits for each
   * colour
   */
  public record Written(long frames, long unreadable) {}

  /**
   * The cameras of a recording.
   *
   * @param history of it
   * @return names of their ports
   */
  public static List<String> cameras(SearchableHistory history) {
    return history.candidates().stream().filter(each -> each.typeName().endsWith("Image"))
        .map(Input.Candidate::id).map(id -> id.port()).toList();
  }

  /**
   * Writes a video.
   *
   * @param history of a recording
   * @param port the camera
   * @param range what of it
   * @param video the file, whose ending says what kind of video; must not be there yet
   * @param rate pictures a second
   * @return what came of it
   * @throws IOException where it cannot be read or written, or where ffmpeg is not installed; with a sentence for users
   * @throws InterruptedException where the thread was interrupted
   */
  public static Written write(SearchableHistory history, String port, TimeRange range, Path video, double rate)
      throws IOException, InterruptedException {
    if (Files.exists(video)) {
      throw new IOException(video + " is there already: name a file that is new");
    }
    CameraVideo made = new CameraVideo(video, rate);
    try {
      history.read(Set.of(port), range, made);
      made.until(made.first + Math.round((made.frames + 1) * NANOS / rate)); // the last picture is one of them
      return made.end(port);
    } finally {
      made.process.ifPresent(FfmpegProcess::close);
    }
  }

  private Written end(String port) throws IOException, InterruptedException {
    if (failure.isPresent()) {
      throw failure.get();
    }
    if (process.isEmpty()) {
      throw new IOException(port + " has no picture in that time that can be shown: those of eight bits for each"
          + " colour, in JPEG and in PNG can");
    }
    process.get().finish();
    return new Written(frames, unreadable);
  }

  @Override
  public void take(RecordedValue value) {
    Optional<BufferedImage> next = value.value() instanceof Image image ? PictureFrame.of(image) : Optional.empty();
    if (next.isEmpty()) {
      unreadable++;
    } else if (failure.isEmpty()) {
      begin(next.get(), value.time());
      until(value.time());
      last = next;
    }
  }

  private void begin(BufferedImage picture, long time) {
    if (process.isEmpty()) {
      first = time;
      try {
        process = Optional.of(FfmpegProcess.start(video, picture.getWidth(), picture.getHeight(), rate));
      } catch (IOException e) {
        failure = Optional.of(e);
      }
    }
  }

  /** Adds the last picture for all frames before a time. */
  private void until(long time) {
    while (last.isPresent() && failure.isEmpty() && first + Math.round(frames * NANOS / rate) < time) {
      try {
        process.orElseThrow().add(last.get());
        frames++;
      } catch (IOException e) {
        failure = Optional.of(e);
      }
    }
  }

  @Override
  public void unreadable(String port, String reason) {
    unreadable++;
  }

  @Override
  public boolean reached(long time) {
    return failure.isEmpty();
  }
}
