package org.robotui.lcm.internal.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.internal.client.Inlet;
import org.robotui.lcm.internal.client.Link;
import org.robotui.lcm.log.EventLogReader;
import org.robotui.lcm.log.LogEvent;

/** Plays a log. */
final class ReadLink implements Link {

  private final Path path;
  private final EventLogReader reader;
  private final double speed;
  private final OptionalLong start;
  private final int maxMessageBytes;
  private final Inlet inlet;
  private final CountDownLatch closing = new CountDownLatch(1);

  ReadLink(Path path, EventLogReader reader, double speed, OptionalLong start, int maxMessageBytes, Inlet inlet) {
    this.path = path;
    this.reader = reader;
    this.speed = speed;
    this.start = start;
    this.maxMessageBytes = maxMessageBytes;
    this.inlet = inlet;
  }

  @Override
  public String where() {
    return "the log " + path + (speed == 0 ? " as fast as possible" : " at speed " + speed);
  }

  @Override
  public String receive() throws IOException {
    if (start.isPresent()) {
      reader.seekToTime(start.getAsLong());
    }
    long damaged = 0;
    long due = System.nanoTime();
    Optional<LogEvent> before = Optional.empty();
    for (Optional<LogEvent> next = reader.next(); next.isPresent(); next = reader.next()) {
      LogEvent event = next.get();
      due += before.map(last -> pause(last.utime(), event.utime())).orElse(0L);
      waitUntil(due);
      deliver(event);
      before = next;
      if (reader.damagedBytes() > damaged) {
        inlet.counters().damaged(
            (reader.damagedBytes() - damaged) + " bytes of the log " + path + " before byte " + event.offset());
        damaged = reader.damagedBytes();
      }
    }
    return "the log " + path + " is at its end";
  }

  /** Nanoseconds between two events; times that go back are passed at once. */
  private long pause(long from, long to) {
    return speed == 0 || to <= from ? 0 : (long) ((double) to - from < 1e12 ? (to - from) * 1000.0 / speed : 0);
  }

  private void waitUntil(long due) throws IOException {
    try {
      if (closing.await(due - System.nanoTime(), TimeUnit.NANOSECONDS)) {
        throw new IOException("closed");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  private void deliver(LogEvent event) {
    if (event.data().remaining() > maxMessageBytes) {
      inlet.counters()
          .damaged("a message of " + event.data().remaining() + " bytes on " + event.channel() + " in the log " + path
              + ", at most " + maxMessageBytes + " are accepted");
    } else if (inlet.wants(event.channel())) {
      inlet.deliver(new LcmMessage(event.channel(), event.data(), path.toString(), System.nanoTime(), event.utime()));
    }
  }

  @Override
  public void publish(byte[] channel, ByteBuffer data) throws IOException {
    throw new IOException("the log " + path + " is only read; write mode=w or mode=a into the URL");
  }

  @Override
  public void close() throws IOException {
    closing.countDown();
    reader.close();
  }
}
