package org.robotui.rfic.recording.internal.tool;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import org.robotui.api.replay.TimeRange;
import org.robotui.recording.RecordingReader;
import org.robotui.rfic.recording.internal.session.RecordedHistory;
import org.robotui.rfic.recording.internal.video.CameraVideo;

/** Writes the pictures of a camera as a video, and says what came of it. */
final class WrittenVideo {
  private final LogCommand command;
  private final Path video;
  private final PrintStream out;

  WrittenVideo(LogCommand command, Path video, PrintStream out) {
    this.command = command;
    this.video = video;
    this.out = out;
  }

  /** Whether all pictures are in it. */
  boolean write(RecordingReader recording) throws IOException, UsageException {
    RecordedHistory history = RecordedHistory.of(recording, LogTool.formats(), LogTool.INSTANCE);
    TimeRange range = LogTool.range(command, recording, history.span()).orElseThrow(
        () -> new UsageException(recording.file() + " has no message in that time"));
    try {
      CameraVideo.Written written =
          CameraVideo.write(history, camera(history), range, video, command.rate().orElse(CameraVideo.RATE));
      out.println(video + ": " + written.frames() + " frames"
          + (written.unreadable() == 0 ? "" : ", " + written.unreadable() + " pictures cannot be shown"));
      recording.damages().forEach(out::println);
      return written.unreadable() == 0 && recording.damages().isEmpty();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("it was interrupted", e);
    }
  }

  private String camera(RecordedHistory history) throws UsageException {
    List<String> cameras = CameraVideo.cameras(history);
    List<String> chosen = cameras.stream().filter(each -> command.topics().isEmpty()
        || command.topics().stream().anyMatch(topic -> topic.matcher(each).matches()
            || topic.matcher("/" + each).matches()))
        .toList();
    if (chosen.size() != 1) {
      throw new UsageException(cameras.isEmpty() ? "there is no camera in it"
          : "a video is of one camera: name it by --topics; there are " + String.join(", ", cameras));
    }
    return chosen.getFirst();
  }
}
