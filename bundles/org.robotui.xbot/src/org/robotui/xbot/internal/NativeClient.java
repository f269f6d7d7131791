package org.robotui.xbot.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.robotui.xbot.Answer;

/**
 * One connection to a supervisor. The native object serves one thread at a time, and none after its end: this sees to
 * both.
 */
public final class NativeClient implements AutoCloseable {
  private static final String OK = "ok";

  /** What the supervisor says unasked. */
  public enum Notice {
    /** Nothing. */
    NONE,
    /** Memory was replaced: attach again. */
    CHANGED,
    /** It is gone. */
    GONE
  }

  private long client;

  private NativeClient(long client) {
    this.client = client;
  }

  /**
   * Connects.
   *
   * @throws IOException with a sentence: no such robot runs, or it is another user's
   */
  public static NativeClient connect(String robot, Duration timeout) throws IOException {
    NativeLink.load();
    return new NativeClient(NativeLink.connect(robot.getBytes(StandardCharsets.UTF_8), millis(timeout)));
  }

  private static int millis(Duration timeout) {
    return (int) Math.clamp(timeout.toMillis(), 0L, Integer.MAX_VALUE);
  }

  private long open() throws IOException {
    if (client == 0) {
      throw new IOException("the connection is closed");
    }
    return client;
  }

  /** Maps the memory. */
  public synchronized Segments attach(Segments.Readers readers, Duration timeout) throws IOException {
    return new Segments(NativeLink.attach(open(), millis(timeout)), readers);
  }

  /** Asks, and waits for the answer. */
  public synchronized Answer request(String words, Duration timeout) throws IOException {
    byte[] reply = NativeLink.request(open(), words.getBytes(StandardCharsets.UTF_8), millis(timeout));
    String text = new String(reply, StandardCharsets.UTF_8);
    int space = text.indexOf(' ');
    return new Answer(text.startsWith(OK + " "), text.substring(space + 1));
  }

  /** Sends references from a direct buffer; false where the supervisor is gone. */
  public synchronized boolean reference(ByteBuffer commands, int joints) throws IOException {
    return NativeLink.reference(open(), commands, joints);
  }

  /** Hears what was said, without waiting. */
  public synchronized Notice notice() throws IOException {
    return Notice.values()[NativeLink.notice(open(), 0)];
  }

  @Override
  public synchronized void close() {
    if (client != 0) {
      NativeLink.close(client);
      client = 0;
    }
  }
}
