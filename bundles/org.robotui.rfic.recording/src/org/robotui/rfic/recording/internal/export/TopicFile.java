package org.robotui.rfic.recording.internal.export;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.data.MessageForm;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;

/** The messages of a channel on their way into a file. For one thread. */
final class TopicFile implements AutoCloseable {
  private final RecordedChannel channel;
  private final PayloadFormat.Reading<DynamicRecord> reading;
  private final Path file;
  private final MessageLines lines;
  private Optional<BufferedWriter> writer = Optional.empty();
  private long written;
  private long unreadable;
  private String reason = "";

  TopicFile(RecordedChannel channel, PayloadFormat.Reading<DynamicRecord> reading, Path file, MessageLines lines) {
    this.channel = channel;
    this.reading = reading;
    this.file = file;
    this.lines = lines;
  }

  /** What reads messages by their fields; none where they cannot be read. */
  static Optional<PayloadFormat.Reading<DynamicRecord>> reading(PayloadFormat format) {
    try {
      return Optional.of(format.reading(new MessageForm.ByFields()));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  void learn(RecordedMessage message) {
    read(message).ifPresent(lines::learn);
  }

  /** Begins the file: messages are written from now on. */
  void begin() throws IOException {
    unreadable = 0;
    BufferedWriter made = Files.newBufferedWriter(file, StandardOpenOption.CREATE_NEW);
    writer = Optional.of(made);
    made.write(lines.head());
  }

  void write(RecordedMessage message, long start) throws IOException {
    Optional<DynamicRecord> record = read(message);
    if (record.isPresent()) {
      try {
        writer.orElseThrow().write(lines.line(message.logTime(), message.logTime() - start, record.get()));
        written++;
      } catch (IllegalArgumentException e) {
        lost(e);
      }
    }
  }

  private Optional<DynamicRecord> read(RecordedMessage message) {
    try {
      return Optional.of(reading.read(message.data().duplicate()));
    } catch (IllegalArgumentException e) {
      lost(e);
      return Optional.empty();
    }
  }

  private void lost(IllegalArgumentException e) {
    unreadable++;
    reason = String.valueOf(e.getMessage());
  }

  ExportedFile outcome() {
    return new ExportedFile(channel.topic(), Optional.of(file), written, unreadable,
        reason.isEmpty() ? lines.note() : reason);
  }

  @Override
  public void close() throws IOException {
    if (writer.isPresent()) {
      writer.get().close();
    }
  }
}
