package org.robotui.rfic.recording.internal.lines;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.Recordings;
import org.robotui.recording.ScanProgress;

/** Opens logs that are lines of text. */
public final class LineLogs {
  /** What can be opened, for users. */
  public static final String KNOWN = "logs of CARMEN and Player (also .gz)";

  private static final int HEAD = 1 << 18;

  private LineLogs() {}

  /**
   * Whether a file is such a log, by what it begins with.
   *
   * @param file any file or folder
   * @return true where {@link #open} would read it
   * @throws RecordingException if it cannot be read
   */
  public static boolean isOne(Path file) throws RecordingException {
    if (Files.isDirectory(file)) {
      return false;
    }
    String head = head(file);
    return PlayerLines.isHead(head.lines()) || CarmenLines.isHead(head.lines());
  }

  /**
   * Reads through a log, and makes a recording of it.
   *
   * @param file the log
   * @param progress hears how far it is
   * @return the recording; who opens it closes it
   * @throws RecordingException if it cannot be read
   */
  public static RecordingReader open(Path file, ScanProgress progress) throws RecordingException {
    return open(file, progress, format(file)
        .orElseThrow(() -> new RecordingException(file, 0, "this is no log that is known here: " + KNOWN + " are")));
  }

  /**
   * The same with messages of its own framework, where they can be told of its lines: those of Player.
   *
   * @param file the log
   * @param progress hears how far it is
   * @return the recording; who opens it closes it
   * @throws RecordingException if it cannot be read
   */
  public static RecordingReader openToSend(Path file, ScanProgress progress) throws RecordingException {
    return PlayerLines.isHead(head(file).lines()) ? open(file, progress, new PlayerDeviceLines())
        : open(file, progress);
  }

  private static RecordingReader open(Path file, ScanProgress progress, LineFormat format) throws RecordingException {
    LineRuns runs = new LineRuns(file, format);
    try {
      runs.scan(progress);
    } catch (RecordingException | RuntimeException e) {
      runs.close();
      throw e;
    }
    return Recordings.of(runs);
  }

  private static Optional<LineFormat> format(Path file) throws RecordingException {
    String head = head(file);
    if (PlayerLines.isHead(head.lines())) {
      return Optional.of(new PlayerLines());
    }
    return CarmenLines.isHead(head.lines()) ? Optional.of(new CarmenLines(CarmenTimes.of(head.lines())))
        : Optional.empty();
  }

  /** What is no text has letters that no log has, and is found to be none by its first line. */
  private static String head(Path file) throws RecordingException {
    try {
      String text = new String(LogBytes.head(file, HEAD), StandardCharsets.UTF_8);
      int end = text.lastIndexOf('\n');
      return end < 0 ? text : text.substring(0, end);
    } catch (IOException e) {
      throw new RecordingException(file, "cannot be read", e);
    }
  }
}
