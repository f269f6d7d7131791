package org.robotui.recording.internal.copy;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordedMetadata;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingDamage;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingPart;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.RecordingWriter;

/** One of the recordings of which a copy is made, and the message that it would give next. */
final class CopiedRecording {
  private final RecordingReader reader;
  private final RecordingPart part;
  private final RecordingWriter writer;
  private final Map<Integer, RecordedChannel> channels = new HashMap<>();
  private final List<RecordedChannel> chosen;
  private Optional<RecordingCursor> cursor = Optional.empty();
  private Optional<RecordedMessage> next = Optional.empty();

  CopiedRecording(RecordingReader reader, RecordingPart part, RecordingWriter writer) {
    this.reader = reader;
    this.part = part;
    this.writer = writer;
    this.chosen = reader.channels().stream().filter(part.channels()).toList();
  }

  /** Channels that are alike in several recordings become one. */
  void channels(Map<List<Object>, RecordedChannel> made) {
    for (RecordedChannel each : chosen) {
      List<Object> alike = List.of(each.topic(), each.messageEncoding(), each.schema(), each.metadata());
      RecordedChannel channel = made.get(alike);
      if (channel == null || channels.containsValue(channel)) { // two of one recording stay two
        channel = writer.channel(each.topic(), each.messageEncoding(), each.schema(), each.metadata());
        made.putIfAbsent(alike, channel);
      }
      channels.put(each.id(), channel);
    }
  }

  void notesAndFiles(List<RecordingDamage> lost) throws RecordingException {
    for (RecordedMetadata metadata : reader.metadata()) {
      writer.note(metadata);
    }
    for (RecordedAttachment file : reader.attachments()) {
      Optional<ByteBuffer> content = content(file, lost);
      if (content.isPresent()) {
        writer.attach(file.name(), file.mediaType(), file.logTime(), file.createTime(), content.get());
      }
    }
  }

  private Optional<ByteBuffer> content(RecordedAttachment file, List<RecordingDamage> lost) {
    try {
      return Optional.of(reader.content(file));
    } catch (RecordingException e) {
      lost.add(new RecordingDamage(file.offset(), e.getMessage()));
      return Optional.empty();
    }
  }

  /** What holds at the beginning of the part; answers how many messages that are. */
  long held() throws RecordingException {
    long begin = part.interval().start();
    long count = 0;
    for (RecordedChannel each : begin == Long.MIN_VALUE ? List.<RecordedChannel>of() : chosen) {
      Optional<RecordedMessage> last =
          each.isLatched() ? reader.latestBefore(each.id(), begin - 1) : Optional.empty();
      if (last.isPresent()) {
        write(last.get(), begin);
        count++;
      }
    }
    return count;
  }

  /** Goes to the first message. */
  void begin() throws RecordingException {
    if (chosen.isEmpty()) {
      return; // for a cursor, no channel means all
    }
    RecordingInterval interval = part.interval();
    cursor = Optional.of(reader.cursor(interval, chosen.stream().map(RecordedChannel::id).collect(Collectors.toSet())));
    advance();
  }

  private void advance() throws RecordingException {
    next = cursor.isPresent() ? cursor.get().next() : Optional.empty();
  }

  boolean hasNext() {
    return next.isPresent();
  }

  /** When its next message was recorded; there must be one. */
  long time() {
    return next.orElseThrow().logTime();
  }

  /** Writes its next message; there must be one. */
  void writeNext() throws RecordingException {
    RecordedMessage message = next.orElseThrow();
    write(message, message.logTime());
    advance();
  }

  private void write(RecordedMessage message, long logTime) throws RecordingException {
    writer.write(channels.get(message.channel().id()), logTime, message.publishTime(), message.sequence(),
        message.data());
  }

  /** What could not be read in it; where it is one of several, with its name. */
  List<RecordingDamage> damages(boolean named) {
    return reader.damages().stream()
        .map(each -> named ? new RecordingDamage(each.offset(), each.problem() + " (in " + reader.file() + ")") : each)
        .toList();
  }
}
