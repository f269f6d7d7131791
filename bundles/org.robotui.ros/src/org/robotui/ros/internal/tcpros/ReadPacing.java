package org.robotui.ros.internal.tcpros;

/**
 * Decides when a reader pauses so that small messages gather: in a flood of them, one read for many costs far less than
 * a read and a change of threads for each. What comes at an ordinary rate, or in large messages, is read at once. Used
 * by one thread.
 */
public final class ReadPacing {

  /** How long a pause is asked for; the system makes it some 50 us longer. */
  public static final long PAUSE_NANOS = 50_000;

  private static final long WINDOW_NANOS = 1_000_000;
  private static final int FLOOD = 20; // messages in a window: 20 000 a second
  private static final int SMALL_BYTES = 1024; // of the mean message; larger ones fill the system's buffers during a
                                               // pause

  private long windowStart;
  private int messages;
  private long bytes;
  private boolean flood;

  /**
   * Counts a message.
   *
   * @param nanos when it was read, by {@link System#nanoTime}
   */
  public void count(int messageBytes, long nanos) {
    messages++;
    bytes += messageBytes;
    long elapsed = nanos - windowStart;
    if (elapsed >= WINDOW_NANOS) {
      flood = messages >= FLOOD * (elapsed / WINDOW_NANOS) && bytes < (long) SMALL_BYTES * messages;
      windowStart = nanos;
      messages = 0;
      bytes = 0;
    }
  }

  /** Whether to pause before the next read from the socket. */
  public boolean isFlood() {
    return flood;
  }
}
