package org.robotui.lcm.internal.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.concurrent.CountDownLatch;
import org.robotui.lcm.internal.client.Link;
import org.robotui.lcm.log.EventLogWriter;

/** Writes what is published into a log. */
final class WriteLink implements Link {

  private final Path path;
  private final EventLogWriter writer;
  private final CountDownLatch closing = new CountDownLatch(1);

  WriteLink(Path path, EventLogWriter writer) {
    this.path = path;
    this.writer = writer;
  }

  @Override
  public String where() {
    return "the log " + path + ", to write";
  }

  @Override
  public String receive() throws IOException {
    try {
      closing.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    throw new IOException("closed");
  }

  @Override
  public void publish(byte[] channel, ByteBuffer data) throws IOException {
    writer.write(ChronoUnit.MICROS.between(Instant.EPOCH, Instant.now()), new String(channel, StandardCharsets.UTF_8),
        data);
  }

  @Override
  public void close() throws IOException {
    closing.countDown();
    writer.close();
  }
}
