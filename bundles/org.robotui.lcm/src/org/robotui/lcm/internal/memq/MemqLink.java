package org.robotui.lcm.internal.memq;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.TimeUnit;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.internal.client.Inlet;
import org.robotui.lcm.internal.client.Link;

/** Brings what is published here to those who subscribed here. A publisher that is too fast waits. */
public final class MemqLink implements Link {

  private final Inlet inlet;
  private final long mostBytes;
  private final Queue<LcmMessage> queue = new ArrayDeque<>();
  private long bytes;
  private boolean closed;
  private Thread receiver;

  public MemqLink(Inlet inlet, long mostBytes) {
    this.inlet = inlet;
    this.mostBytes = mostBytes;
  }

  @Override
  public String where() {
    return "memory";
  }

  @Override
  public String receive() throws IOException {
    synchronized (queue) {
      receiver = Thread.currentThread();
    }
    for (Optional<LcmMessage> next = take(); next.isPresent(); next = take()) {
      inlet.deliver(next.get());
    }
    throw new IOException("closed");
  }

  private Optional<LcmMessage> take() throws IOException {
    synchronized (queue) {
      while (queue.isEmpty() && !closed) {
        await();
      }
      Optional<LcmMessage> message = closed ? Optional.empty() : Optional.of(queue.remove());
      message.ifPresent(taken -> bytes -= taken.data().remaining());
      queue.notifyAll();
      return message;
    }
  }

  @Override
  public void publish(byte[] channel, ByteBuffer data) throws IOException {
    ByteBuffer copy = ByteBuffer.allocate(data.remaining()).put(data).flip();
    long utime = TimeUnit.MILLISECONDS.toMicros(System.currentTimeMillis());
    LcmMessage message =
        new LcmMessage(new String(channel, StandardCharsets.UTF_8), copy, "memory", System.nanoTime(), utime);
    synchronized (queue) {
      // a listener that publishes must not wait for itself
      while (!closed && !queue.isEmpty() && bytes + copy.limit() > mostBytes && Thread.currentThread() != receiver) {
        await();
      }
      if (closed) {
        throw new IOException("closed");
      }
      queue.add(message);
      bytes += copy.limit();
      queue.notifyAll();
    }
  }

  private void await() throws IOException {
    try {
      queue.wait();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  @Override
  public void close() {
    synchronized (queue) {
      closed = true;
      queue.notifyAll();
    }
  }
}
