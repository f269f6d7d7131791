package org.robotui.ros.internal.tcpros;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;

/** Writes frames so that many small ones share a write and a large one is not copied. */
public final class FrameWriter {

  private static final int SMALL = 16 * 1024;

  private final OutputStream out;
  private final byte[] buffer = new byte[64 * 1024];
  private int used;

  public FrameWriter(OutputStream out) {
    this.out = out;
  }

  /** Writes a frame that holds its length already; small ones wait for {@link #flush}. */
  public void write(ByteBuffer frame) throws IOException {
    int length = frame.remaining();
    if (length > SMALL) {
      flush();
      out.write(frame.array(), frame.arrayOffset() + frame.position(), length);
      return;
    }
    if (used + length > buffer.length) {
      flush();
    }
    System.arraycopy(frame.array(), frame.arrayOffset() + frame.position(), buffer, used, length);
    used += length;
  }

  public void flush() throws IOException {
    if (used > 0) {
      out.write(buffer, 0, used);
      used = 0;
    }
  }
}
