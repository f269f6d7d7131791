package org.robotui.ros.internal.tcpros;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;

/** A socket's input that may have a deadline for everything read until the deadline is lifted. */
public final class TimedStream extends InputStream {

  private static final long NONE = Long.MAX_VALUE;

  private final Socket socket;
  private final InputStream in;
  private long deadline = NONE;

  public TimedStream(Socket socket) throws IOException {
    this.socket = socket;
    this.in = socket.getInputStream();
  }

  public void within(Duration time) {
    deadline = System.nanoTime() + time.toNanos();
  }

  public void withoutDeadline() throws IOException {
    deadline = NONE;
    socket.setSoTimeout(0);
  }

  @Override
  public int read() throws IOException {
    arm();
    return in.read();
  }

  @Override
  public int read(byte[] bytes, int offset, int length) throws IOException {
    arm();
    return in.read(bytes, offset, length);
  }

  private void arm() throws IOException {
    if (deadline != NONE) {
      long left = (deadline - System.nanoTime()) / 1_000_000;
      if (left <= 0) {
        throw new SocketTimeoutException("timed out");
      }
      socket.setSoTimeout((int) Math.min(Integer.MAX_VALUE, left));
    }
  }
}
