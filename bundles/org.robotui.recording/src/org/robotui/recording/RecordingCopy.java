package org.robotui.recording;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Writes what can be read of a recording as an MCAP file with an index: bags become MCAP, damaged files whole ones.
 * Messages come in order of their log times. Any thread may use it.
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
    if (isSame(from.file(), to)) {
      throw new IllegalArgumentException("a recording cannot be copied to itself: " + to);
    }
    List<RecordingDamage> lost = new ArrayList<>();
    try (RecordingWriter writer = RecordingWriter.create(to, options)) {
      for (RecordedMetadata metadata : from.metadata()) {
        writer.note(metadata);
      }
      for (RecordedAttachment file : from.attachments()) {
        Optional<ByteBuffer> content = content(from, file, lost);
        if (content.isPresent()) {
          writer.attach(file.name(), file.mediaType(), file.logTime(), file.createTime(), content.get());
        }
      }
      long messages = messages(from, writer);
      lost.addAll(from.damages());
      return new Outcome(messages, lost);
    }
  }

  private static boolean isSame(Path one, Path other) throws RecordingException {
    try {
      return Files.exists(other) && Files.isSameFile(one, other);
    } catch (IOException e) {
      throw new RecordingException(other, "cannot be looked at", e);
    }
  }

  private static Optional<ByteBuffer> content(RecordingReader from, RecordedAttachment file,
      List<RecordingDamage> lost) {
    try {
      return Optional.of(from.content(file));
    } catch (RecordingException e) {
      lost.add(new RecordingDamage(file.offset(), e.getMessage()));
      return Optional.empty();
    }
  }

  private static long messages(RecordingReader from, RecordingWriter writer) throws RecordingException {
    Map<Integer, RecordedChannel> channels = new HashMap<>();
    for (RecordedChannel channel : from.channels()) {
      channels.put(channel.id(),
          writer.channel(channel.topic(), channel.messageEncoding(), channel.schema(), channel.metadata()));
    }
    RecordingCursor cursor = from.cursor(RecordingInterval.ALWAYS, Set.of());
    long count = 0;
    for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
      RecordedMessage message = next.get();
      writer.write(channels.get(message.channel().id()), message.logTime(), message.publishTime(),
          message.sequence(), message.data());
      count++;
    }
    return count;
  }
}
