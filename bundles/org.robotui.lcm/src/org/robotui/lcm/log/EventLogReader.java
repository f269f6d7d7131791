package org.robotui.lcm.log;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Reads the logs of {@code lcm-logger}, also damaged ones: it goes on at the next event that is whole, and counts what
 * it left out. Not for several threads.
 *
 * <p>Source: "LCM Log File format" in LCM's documentation.
 */
public final class EventLogReader implements AutoCloseable {

  private final Path path;
  private final LogWindow file;
  private long at;
  private long damaged;

  private EventLogReader(Path path, LogWindow file) {
    this.path = path;
    this.file = file;
  }

  /**
   * Opens a log at its start.
   *
   * @param path the file
   * @return the reader
   * @throws IOException if it cannot be opened; the message names it
   */
  public static EventLogReader open(Path path) throws IOException {
    try {
      return new EventLogReader(path, LogWindow.open(path));
    } catch (IOException e) {
      throw new IOException(
          "the log " + path + " cannot be opened: " + e.getMessage() + " (" + e.getClass().getSimpleName() + ")", e);
    }
  }

  /** Where an event lies. */
  record Span(long start, int channelLength, int dataLength) {

    long end() {
      return start + LogFormat.HEADER + channelLength + dataLength;
    }
  }

  /**
   * Reads the next event.
   *
   * @return the event; empty at the end. Where the log is still written, a later call may answer another one
   * @throws IOException if the file cannot be read
   */
  public Optional<LogEvent> next() throws IOException {
    Optional<Span> span = nextSpan();
    return span.isEmpty() ? Optional.empty() : Optional.of(event(span.get()));
  }

  /** Finds the next event and goes behind it. */
  Optional<Span> nextSpan() throws IOException {
    while (file.size() - at >= LogFormat.HEADER) {
      Optional<Span> span = whole(at);
      if (span.isPresent()) {
        at = span.get().end();
        return span;
      }
      if (isUnfinished(at)) {
        return Optional.empty();
      }
      long next = file.find(LogFormat.SYNC, at + 1);
      damaged += next - at;
      at = next;
    }
    return Optional.empty();
  }

  /** The event at a place, if there is one that does not swallow others. */
  private Optional<Span> whole(long start) throws IOException {
    Optional<Span> span = claimed(start).filter(found -> found.end() <= fileSize());
    if (span.isEmpty() || isFollowed(span.get())) {
      return span;
    }
    // what follows is no event: either that is damaged, or this one was cut off and the next ones are taken for its
    // bytes
    long inside = file.find(LogFormat.SYNC, start + Integer.BYTES);
    while (inside < span.get().end()) {
      Optional<Span> other = claimed(inside).filter(found -> found.end() <= fileSize());
      if (other.isPresent() && isFollowed(other.get())) {
        return Optional.empty();
      }
      inside = file.find(LogFormat.SYNC, inside + 1);
    }
    return span;
  }

  private boolean isFollowed(Span span) throws IOException {
    return file.size() - span.end() < Integer.BYTES || file.getInt(span.end()) == LogFormat.SYNC;
  }

  /** What a header says, if it is one. */
  private Optional<Span> claimed(long start) throws IOException {
    if (file.size() - start < LogFormat.HEADER || file.getInt(start) != LogFormat.SYNC) {
      return Optional.empty();
    }
    int channel = file.getInt(start + 20);
    int data = file.getInt(start + 24);
    return channel < 1 || channel > LogFormat.MOST_CHANNEL || data < 0 ? Optional.empty()
        : Optional.of(new Span(start, channel, data));
  }

  /** The last event of a log that is still written, or whose writer was killed. */
  private boolean isUnfinished(long start) throws IOException {
    Optional<Span> span = claimed(start).filter(found -> found.end() > fileSize());
    return span.isPresent() && file.find(LogFormat.SYNC, start + Integer.BYTES) >= file.size();
  }

  private long fileSize() {
    try {
      return file.size();
    } catch (IOException e) {
      return 0;
    }
  }

  LogEvent event(Span span) throws IOException {
    long body = span.start() + LogFormat.HEADER;
    String channel = new String(file.get(body, span.channelLength()), StandardCharsets.UTF_8);
    byte[] data = file.get(body + span.channelLength(), span.dataLength());
    return new LogEvent(file.getLong(span.start() + 4), utime(span), channel, ByteBuffer.wrap(data), span.start());
  }

  long utime(Span span) throws IOException {
    return file.getLong(span.start() + 12);
  }

  /** What its message begins with; empty where it is too short. */
  Optional<Long> fingerprint(Span span) throws IOException {
    return span.dataLength() < Long.BYTES ? Optional.empty()
        : Optional.of(file.getLong(span.start() + LogFormat.HEADER + span.channelLength()));
  }

  String channel(Span span) throws IOException {
    return new String(file.get(span.start() + LogFormat.HEADER, span.channelLength()), StandardCharsets.UTF_8);
  }

  /**
   * Goes to a place.
   *
   * @param offset a byte of the file; reading goes on at the first event from there
   */
  public void seek(long offset) {
    if (offset < 0) {
      throw new IllegalArgumentException("byte " + offset);
    }
    at = offset;
  }

  /**
   * Goes to a time, without reading all that lies before it. The times of a log rise.
   *
   * @param utime microseconds since 1970; reading goes on at the first event that is not earlier
   * @throws IOException if the file cannot be read
   */
  public void seekToTime(long utime) throws IOException {
    long counted = damaged;
    long low = 0;
    long high = file.size();
    while (low < high) {
      long middle = (low + high) >>> 1;
      at = middle;
      Optional<Span> span = nextSpan();
      if (span.isEmpty() || utime(span.get()) >= utime) {
        high = middle;
      } else {
        low = span.get().end();
      }
    }
    at = low;
    damaged = counted;
  }

  /**
   * Where reading goes on.
   *
   * @return a byte of the file
   */
  public long position() {
    return at;
  }

  /**
   * How long the file is.
   *
   * @return bytes
   * @throws IOException if the file cannot be read
   */
  public long size() throws IOException {
    return file.size();
  }

  /**
   * How much was left out because it is no event.
   *
   * @return bytes
   */
  public long damagedBytes() {
    return damaged;
  }

  @Override
  public void close() throws IOException {
    file.close();
  }

  @Override
  public String toString() {
    return "log " + path;
  }
}
