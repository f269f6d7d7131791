package org.robotui.ros.internal.xmlrpc;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.Arrays;

/** Reads a socket against a deadline for the whole message, so that a peer that drips bytes gains nothing. */
final class TimedInput {

  private static final int FIRST_CHUNK = BodyBudget.FREE;

  private final Socket socket;
  private final InputStream in;
  private final byte[] buffer = new byte[8 * 1024];
  private int position;
  private int limit;
  private long deadline;

  TimedInput(Socket socket) throws IOException {
    this.socket = socket;
    this.in = socket.getInputStream();
    within(Duration.ofSeconds(10));
  }

  void within(Duration time) {
    deadline = System.nanoTime() + time.toNanos();
  }

  /** Waits for the first byte of the next message, which may take longer than the message itself. */
  void awaitData(Duration time) throws IOException {
    within(time);
    if (position == limit) {
      fill();
    }
  }

  int read() throws IOException {
    if (position == limit) {
      fill();
    }
    return limit < 0 ? -1 : buffer[position++] & 0xff;
  }

  /** Is asked before more memory is taken. */
  interface Growth {

    void grow(int bytes) throws IOException;
  }

  /** Reads exactly so many bytes; memory grows with what arrives, not with what was announced. */
  byte[] readFully(int length, Growth growth) throws IOException {
    byte[] out = new byte[Math.min(length, FIRST_CHUNK)];
    int have = 0;
    while (have < length) {
      if (have == out.length) {
        int larger = (int) Math.min(length, out.length * 2L);
        growth.grow(larger);
        out = Arrays.copyOf(out, larger);
      }
      have += readInto(out, have);
    }
    return out;
  }

  private int readInto(byte[] out, int offset) throws IOException {
    if (position == limit) {
      fill();
    }
    if (limit < 0) {
      throw new XmlRpcException("HTTP body cut off");
    }
    int n = Math.min(limit - position, out.length - offset);
    System.arraycopy(buffer, position, out, offset, n);
    position += n;
    return n;
  }

  private void fill() throws IOException {
    if (limit < 0) {
      return;
    }
    long left = (deadline - System.nanoTime()) / 1_000_000;
    if (left <= 0) {
      throw new SocketTimeoutException("timed out");
    }
    socket.setSoTimeout((int) Math.min(Integer.MAX_VALUE, left));
    position = 0;
    limit = in.read(buffer);
    if (limit < 0) {
      position = -1;
    }
  }
}
