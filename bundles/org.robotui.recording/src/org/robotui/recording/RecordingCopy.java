package org.robotui.recording;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;
import org.robotui.recording.internal.bag.BagWriter;
import org.robotui.recording.internal.copy.CopyRun;

/**
 * Writes what can be read of recordings as an MCAP file with an index, or as a bag: bags become MCAP, damaged files
 * whole ones, several recordings one, a part of one a recording of its own. Messages come in order of their log times.
 * Any thread may use it.
 */
public final class RecordingCopy {

  private RecordingCopy() {}

  /**
   * What became of it.
   *
   * @param messages how many messages were written
   * @param damages what could not be read, and is missing in the copy
   */
  public record Outcome(long messages, List<RecordingDamage> damages) {

    /** As the components say; the damages are copied. */
    public Outcome {
      damages = List.copyOf(damages);
    }
  }

  /**
   * Copies a recording.
   *
   * @param from stays as it is
   * @param to the file that is written; it must not be the one that is read
   * @param options how it is written
   * @return what became of it
   * @throws RecordingException if something cannot be read or written at all; the copy is then as long as it came
   * @throws IllegalArgumentException if both are the same file
   */
  public static Outcome copy(RecordingReader from, Path to, WriterOptions options) throws RecordingException {
    return copy(List.of(from), RecordingPart.ALL, to, options);
  }

  /**
   * Copies a part of recordings into one. What holds at the beginning of the part is taken along, at the log time of
   * the beginning: the last message before it of each {@linkplain RecordedChannel#isLatched latched} channel. Files and
   * notes are taken whatever their times. Channels of several recordings that are alike become one.
   *
   * @param from stay as they are
   * @param part which messages
   * @param to the file that is written; it must not be one that is read
   * @param options how it is written
   * @return what became of it; damages of several recordings name their files
   * @throws RecordingException if something cannot be read or written at all; the copy is then as long as it came
   * @throws IllegalArgumentException if the file is one of those that are read
   */
  public static Outcome copy(List<RecordingReader> from, RecordingPart part, Path to, WriterOptions options)
      throws RecordingException {
    refuseSame(from, to);
    try (RecordingWriter writer = RecordingWriter.create(to, options)) {
      return new CopyRun(from, part, writer).run();
    }
  }

  /**
   * Copies a part of recordings into a bag of ROS 1, which has no place for files and notes, and LZ4 instead of zstd.
   *
   * @param from stay as they are
   * @param part which messages; all of its channels {@linkplain #fitsBag fit a bag}
   * @param to the file that is written; it must not be one that is read
   * @param options how it is written
   * @param sums gives the MD5 sum of the type of a channel, as ROS 1 computes it
   * @return what became of it; damages of several recordings name their files
   * @throws RecordingException if something cannot be read or written at all; the copy is then as long as it came
   * @throws IllegalArgumentException if the file is one of those that are read, or a channel does not fit
   */
  public static Outcome toBag(List<RecordingReader> from, RecordingPart part, Path to, WriterOptions options,
      Function<RecordedChannel, String> sums) throws RecordingException {
    refuseSame(from, to);
    try (RecordingWriter writer = BagWriter.create(to, options, sums)) {
      return new CopyRun(from, part, writer).run();
    }
  }

  /**
   * Whether messages of a channel may be in a bag: those of ROS 1 whose definition is known.
   *
   * @param channel of any recording
   * @return whether they may
   */
  public static boolean fitsBag(RecordedChannel channel) {
    return BagWriter.fits(channel);
  }

  private static void refuseSame(List<RecordingReader> from, Path to) throws RecordingException {
    for (RecordingReader each : from) {
      if (isSame(each.file(), to)) {
        throw new IllegalArgumentException("a recording cannot be copied to itself: " + to);
      }
    }
  }

  private static boolean isSame(Path one, Path other) throws RecordingException {
    try {
      return Files.exists(other) && Files.isSameFile(one, other);
    } catch (IOException e) {
      throw new RecordingException(other, "cannot be looked at", e);
    }
  }
}
