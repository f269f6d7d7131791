package org.robotui.player.internal.io;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;

/**
 * A socket's input in which the first byte of a message may take any time, but the rest of it only some. Many small messages are taken from the
 * socket at once. For one thread.
 */
public final class TimedStream extends InputStream {

  private static final long NONE = Long.MAX_VALUE;
  private static final int A_MILLION = 1_000_000;
  private static final int AT_ONCE = 1 << 16;

  private final Socket socket;
  private final InputStream in;
  private final Duration rest;
  private final byte[] taken = new byte[AT_ONCE];
  private int begin;
  private int end;
  private boolean fresh;
  private long deadline = NONE;

  /** Reads a socket; the rest of a message may take so long. */
  public TimedStream(Socket socket, Duration rest) throws IOException {
    this.socket = socket;
    this.in = socket.getInputStream();
    this.rest = rest;
  }

  /** Whatever is read next must have come within that time. */
  public void within(Duration time) {
    fresh = false;
    deadline = System.nanoTime() + time.toNanos();
  }

  /** The next byte begins a message, whenever it comes. */
  public void nextMessage() {
    fresh = true;
    deadline = NONE;
  }

  @Override
  public int read() throws IOException {
    byte[] one = new byte[1];
    return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
  }

  @Override
  public int read(byte[] bytes, int offset, int length) throws IOException {
    int count = length >= AT_ONCE && begin == end ? readInTime(bytes, offset, length) : copy(bytes, offset, length);
    if (fresh) {
      within(rest);
    }
    return count;
  }

  private int copy(byte[] bytes, int offset, int length) throws IOException {
    if (begin == end) {
      begin = 0;
      end = Math.max(0, readInTime(taken, 0, AT_ONCE));
      if (end == 0) {
        return -1;
      }
    }
    int count = Math.min(length, end - begin);
    System.arraycopy(taken, begin, bytes, offset, count);
    begin += count;
    return count;
  }

  private int readInTime(byte[] bytes, int offset, int length) throws IOException {
    try {
      arm();
      return in.read(bytes, offset, length);
    } catch (SocketTimeoutException e) {
      SocketTimeoutException late = new SocketTimeoutException("the peer did not send the greeting, or the rest of a message, in time");
      late.initCause(e);
      throw late;
    }
  }

  private void arm() throws IOException {
    if (deadline == NONE) {
      socket.setSoTimeout(0);
      return;
    }
    long left = (deadline - System.nanoTime()) / A_MILLION;
    if (left <= 0) {
      throw new SocketTimeoutException("the time is over");
    }
    socket.setSoTimeout((int) Math.min(Integer.MAX_VALUE, left));
  }
}
