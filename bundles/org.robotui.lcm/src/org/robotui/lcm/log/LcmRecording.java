package org.robotui.lcm.log;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.Recordings;
import org.robotui.recording.ScanProgress;

/** Logs of LCM as recordings, beside those of other frameworks. Any thread may use it. */
public final class LcmRecording {

  private LcmRecording() {}

  /**
   * Whether a file is a log of LCM, by what it begins with.
   *
   * @param file any file
   * @return true where {@link #open} would find events
   * @throws RecordingException if it cannot be read
   */
  public static boolean isOne(Path file) throws RecordingException {
    if (Files.isDirectory(file)) {
      return false;
    }
    try (InputStream bytes = Files.newInputStream(file)) {
      byte[] head = bytes.readNBytes(Integer.BYTES);
      return head.length == Integer.BYTES && ByteBuffer.wrap(head).getInt() == LogFormat.SYNC;
    } catch (IOException e) {
      throw new RecordingException(file, "cannot be read", e);
    }
  }

  /**
   * Reads through a log, and makes a recording of it. A channel is one for each type that was sent by it, which the
   * first bytes of messages tell: their encoding is {@code lcm}, and so is that of definitions, which are declarations
   * as {@code .lcm} files have them. Of a type that is not known, the channel's {@code fingerprint} is noted alone.
   * Times are those of reception.
   *
   * @param file the log
   * @param types the types that are known
   * @param progress hears how far it is
   * @return the recording; who opens it closes it
   * @throws RecordingException if it cannot be read
   */
  public static RecordingReader open(Path file, TypeLibrary types, ScanProgress progress) throws RecordingException {
    LogRuns runs = new LogRuns(file, new LogChannels(types));
    try (EventLogReader reader = EventLogReader.open(file)) {
      long end = 0;
      for (Optional<EventLogReader.Span> next = reader.nextSpan(); next.isPresent(); next = reader.nextSpan()) {
        EventLogReader.Span span = next.get();
        runs.add(reader, span, end);
        end = span.end();
        progress.scanned(end, reader.size());
      }
      runs.complete(end, reader.size());
    } catch (IOException e) {
      throw new RecordingException(file, "cannot be read", e);
    }
    return Recordings.of(runs);
  }
}
