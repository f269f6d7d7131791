package org.robotui.lcm.log;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.recording.MessageRuns;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingDamage;
import org.robotui.recording.RecordingException;

/** The events of a log in pieces. Filled by one thread, then read by any, one at a time. */
final class LogRuns implements MessageRuns {

  private static final long BYTES = 1 << 20;
  private static final int MOST_MESSAGE = 128 << 20;
  private static final int MOST_DAMAGES = 1000;
  private static final long NANOS = 1000;
  private static final long LATEST = Long.MAX_VALUE / NANOS;

  /** From the start of an event up to the end of another one. */
  private record Piece(long from, long to) {}

  private final Path file;
  private final LogChannels channels;
  private final List<Run> runs = new ArrayList<>();
  private final List<Piece> pieces = new ArrayList<>();
  private final List<RecordingDamage> damages = new ArrayList<>();
  private final Map<Integer, Long> counts = new HashMap<>();
  private long from;
  private long to;
  private long start = Long.MAX_VALUE;
  private long last = Long.MIN_VALUE;

  LogRuns(Path file, LogChannels channels) {
    this.file = file;
    this.channels = channels;
  }

  /** Adds the next event; what lies before it and behind the one before is damaged. */
  void add(EventLogReader reader, EventLogReader.Span span, long before) throws IOException {
    lost(before, span.start());
    Optional<RecordedChannel> channel = channel(reader, span);
    long utime = reader.utime(span);
    if (channel.isEmpty() || !isTime(utime)) {
      damaged(span.start(), channel.isEmpty() ? "an event was left out: it is too long, or of too many channels"
          : "an event was left out: its time is " + utime + " microseconds");
      return;
    }
    if (counts.isEmpty()) {
      from = span.start();
    }
    to = span.end();
    start = Math.min(start, utime * NANOS);
    last = Math.max(last, utime * NANOS);
    counts.merge(channel.get().id(), 1L, Long::sum);
    if (to - from >= BYTES) {
      end(from, to);
    }
  }

  /** Whether it can be said in nanoseconds. */
  private static boolean isTime(long micros) {
    return micros >= -LATEST && micros <= LATEST;
  }

  private Optional<RecordedChannel> channel(EventLogReader reader, EventLogReader.Span span) throws IOException {
    return span.dataLength() > MOST_MESSAGE ? Optional.empty()
        : channels.of(reader.channel(span), reader.fingerprint(span));
  }

  /** No event comes any more. */
  void complete(long end, long size) {
    if (!counts.isEmpty()) {
      end(from, to);
    }
    lost(end, size);
  }

  private void lost(long begin, long end) {
    if (end > begin) {
      damaged(begin, (end - begin) + " bytes are no event, and were left out");
    }
  }

  private void damaged(long place, String problem) {
    if (damages.size() < MOST_DAMAGES) {
      damages.add(new RecordingDamage(place, problem));
    }
  }

  private void end(long begin, long end) {
    runs.add(new Run(start, last, counts));
    pieces.add(new Piece(begin, end));
    counts.clear();
    start = Long.MAX_VALUE;
    last = Long.MIN_VALUE;
  }

  @Override
  public Path file() {
    return file;
  }

  @Override
  public String format() {
    return "lcm log";
  }

  @Override
  public List<RecordedChannel> channels() {
    return channels.all();
  }

  @Override
  public List<Run> runs() {
    return List.copyOf(runs);
  }

  @Override
  public List<RecordedMessage> read(int run) throws RecordingException {
    Piece piece = pieces.get(run);
    List<RecordedMessage> messages = new ArrayList<>();
    // opened for each: a thread that is interrupted closes the file for all
    try (EventLogReader reader = EventLogReader.open(file)) {
      reader.seek(piece.from());
      for (Optional<EventLogReader.Span> span = reader.nextSpan(); span.isPresent()
          && span.get().end() <= piece.to(); span = reader.nextSpan()) {
        message(reader, span.get()).ifPresent(messages::add);
      }
      return messages;
    } catch (IOException e) {
      throw new RecordingException(file, "cannot be read any more", e);
    }
  }

  private Optional<RecordedMessage> message(EventLogReader reader, EventLogReader.Span span) throws IOException {
    long time = reader.utime(span);
    Optional<RecordedChannel> channel = channel(reader, span);
    if (channel.isEmpty() || !isTime(time)) {
      return Optional.empty();
    }
    LogEvent event = reader.event(span);
    ByteBuffer data = event.data();
    return Optional.of(new RecordedMessage(channel.get(), time * NANOS, time * NANOS,
        Math.max(0, event.number()) & 0xffff_ffffL, data));
  }

  @Override
  public List<RecordingDamage> damages() {
    return List.copyOf(damages);
  }

  @Override
  public void close() {
    // files are open while they are read
  }
}
