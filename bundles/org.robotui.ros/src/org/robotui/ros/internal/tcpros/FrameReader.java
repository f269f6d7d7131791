package org.robotui.ros.internal.tcpros;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/**
 * Reads frames, each a 32-bit length and so many bytes. Small frames share reads through a buffer; of a large one all
 * but its start goes straight from the socket into the array that is handed over. Memory grows with the bytes that
 * arrive: a length alone allocates no more than this peer proved to send before.
 */
public final class FrameReader {

  private static final int FIRST_TRUST = 64 * 1024;

  private final InputStream in;
  private final byte[] buffer;
  private int position;
  private int limit;
  private int trusted = FIRST_TRUST;

  public FrameReader(InputStream in, int bufferBytes) {
    this.in = in;
    this.buffer = new byte[bufferBytes];
  }

  /**
   * Reads the next frame into a fresh array.
   *
   * @throws EOFException if the peer closed between two frames
   * @throws ProtocolException if the length is above the limit or the frame is cut off
   */
  public byte[] next(long maxBytes, String what) throws IOException {
    int length = length(maxBytes, what);
    byte[] frame = new byte[Math.min(length, trusted)];
    int have = 0;
    while (have < length) {
      if (have == frame.length) {
        frame = Arrays.copyOf(frame, (int) Math.min(length, frame.length * 2L));
      }
      have += readInto(frame, have, length, what);
    }
    trusted = Math.max(trusted, length);
    return frame;
  }

  /** Reads one byte. */
  public int nextByte(String what) throws IOException {
    if (limit == position) {
      fill();
    }
    if (limit < 0) {
      throw new EOFException("closed by the peer before " + what);
    }
    return buffer[position++] & 0xff;
  }

  /** Whether bytes wait in the buffer that were read but not used yet. */
  public boolean hasBuffered() {
    return limit > position;
  }

  private int length(long maxBytes, String what) throws IOException {
    int have = Math.max(0, limit - position);
    while (have < Integer.BYTES) {
      compact();
      int n = in.read(buffer, limit, buffer.length - limit);
      if (n < 0) {
        throw have == 0 ? new EOFException("closed by the peer")
            : new ProtocolException("cut off in the length of " + what);
      }
      limit += n;
      have += n;
    }
    long length = Integer.toUnsignedLong(littleEndian());
    if (length > maxBytes) {
      throw new ProtocolException(what + " of " + length + " bytes announced, at most " + maxBytes + " are accepted");
    }
    return (int) length;
  }

  private int littleEndian() {
    int value = buffer[position] & 0xff | (buffer[position + 1] & 0xff) << 8 | (buffer[position + 2] & 0xff) << 16
        | buffer[position + 3] << 24;
    position += Integer.BYTES;
    return value;
  }

  private void compact() {
    int have = Math.max(0, limit - position);
    if (have > 0 && position > 0) {
      System.arraycopy(buffer, position, buffer, 0, have);
    }
    position = 0;
    limit = have;
  }

  private int readInto(byte[] frame, int offset, int length, String what) throws IOException {
    int wanted = frame.length - offset;
    int n;
    if (limit > position) {
      n = drain(frame, offset, wanted);
    } else if (wanted >= buffer.length) {
      n = in.read(frame, offset, wanted);
    } else {
      fill();
      n = limit < 0 ? -1 : drain(frame, offset, wanted);
    }
    if (n < 0) {
      throw new ProtocolException(what + " cut off: " + offset + " of " + length + " bytes came");
    }
    return n;
  }

  private int drain(byte[] frame, int offset, int wanted) {
    int n = Math.min(wanted, limit - position);
    System.arraycopy(buffer, position, frame, offset, n);
    position += n;
    return n;
  }

  private void fill() throws IOException {
    position = 0;
    limit = in.read(buffer, 0, buffer.length);
    if (limit < 0) {
      position = -1;
    }
  }
}
