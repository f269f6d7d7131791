package org.robotui.net.socket;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;

/**
 * A socket's input with a time by which all that is read must have come, so that a peer that sends byte by byte gains
 * nothing. Reading blocks until bytes come, the time is over ({@link SocketTimeoutException}), or the socket is closed.
 * For one thread.
 */
public final class DeadlineInput extends InputStream {

  private static final long NONE = Long.MAX_VALUE;
  private static final int NANOS_PER_MILLI = 1_000_000;

  private final Socket socket;
  private final InputStream in;
  private final byte[] buffer;
  private int begin;
  private int end;
  private long restNanos = NONE;
  private long deadline = NONE;

  /**
   * Reads a socket, at first without a deadline.
   *
   * @param socket connected
   * @param bufferBytes how much is taken from the socket at once where less is asked for; 0 for readers with a buffer
   * of their own
   * @throws IOException if the socket is not connected, or closed
   */
  public DeadlineInput(Socket socket, int bufferBytes) throws IOException {
    this.socket = socket;
    this.in = socket.getInputStream();
    this.buffer = new byte[bufferBytes];
  }

  /**
   * Whatever is read next must have come within a time.
   *
   * @param time from now on
   */
  public void within(Duration time) {
    restNanos = NONE;
    deadline = System.nanoTime() + time.toNanos();
  }

  /** Whatever is read next may take any time. */
  public void withoutDeadline() {
    restNanos = NONE;
    deadline = NONE;
  }

  /**
   * The next byte begins a message, whenever it comes.
   *
   * @param rest how long all that follows it may take
   */
  public void nextMessage(Duration rest) {
    deadline = NONE;
    restNanos = rest.toNanos();
  }

  /**
   * The next byte begins a message.
   *
   * @param first how long it may take to come
   * @param rest how long all that follows it may take
   */
  public void nextMessage(Duration first, Duration rest) {
    within(first);
    restNanos = rest.toNanos();
  }

  @Override
  public int read() throws IOException {
    if (begin < end && restNanos == NONE) {
      return buffer[begin++] & 0xff;
    }
    byte[] one = new byte[1];
    return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
  }

  @Override
  public int read(byte[] bytes, int offset, int length) throws IOException {
    if (length == 0) {
      return 0; // as asked for at the end of readNBytes: there may be nothing more to wait for
    }
    int count = length >= buffer.length && begin == end ? receive(bytes, offset, length) : copy(bytes, offset, length);
    if (restNanos != NONE) {
      deadline = System.nanoTime() + restNanos;
      restNanos = NONE;
    }
    return count;
  }

  private int copy(byte[] bytes, int offset, int length) throws IOException {
    if (begin == end) {
      begin = 0;
      end = Math.max(0, receive(buffer, 0, buffer.length));
      if (end == 0) {
        return -1;
      }
    }
    int count = Math.min(length, end - begin);
    System.arraycopy(buffer, begin, bytes, offset, count);
    begin += count;
    return count;
  }

  private int receive(byte[] bytes, int offset, int length) throws IOException {
    try {
      socket.setSoTimeout(timeout());
      return in.read(bytes, offset, length);
    } catch (SocketTimeoutException e) {
      SocketTimeoutException late = new SocketTimeoutException("the peer did not send what was expected in time");
      late.initCause(e);
      throw late;
    }
  }

  /** In milliseconds; 0 is for ever. */
  private int timeout() throws SocketTimeoutException {
    if (deadline == NONE) {
      return 0;
    }
    long left = (deadline - System.nanoTime()) / NANOS_PER_MILLI;
    if (left <= 0) {
      throw new SocketTimeoutException("the time is over");
    }
    return (int) Math.min(Integer.MAX_VALUE, left);
  }
}
