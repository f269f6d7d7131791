package org.robotui.roboframe.wire;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.net.link.Framing;
import org.robotui.roboframe.internal.BrokerReader;
import org.robotui.roboframe.internal.BrokerWriter;

/** Messages as frames: four bytes of length, one that says which message, and the message, little endian. */
public final class BrokerFraming implements Framing<BrokerMessage> {

  /** The version of the wire that is spoken here. */
  public static final int VERSION = 1;
  /** Where an application listens unless it is told otherwise. */
  public static final int PORT = 7420;
  /** The longest frame that is taken, without its length. */
  public static final int LONGEST = 1 << 24;
  /** The most keys that an application may have. */
  public static final int MOST_KEYS = 1024;

  /** Says nothing of its own. */
  public BrokerFraming() {
    // no state
  }

  @Override
  public BrokerMessage read(InputStream in) throws IOException {
    ByteBuffer length = ByteBuffer.wrap(exactly(in, Integer.BYTES)).order(ByteOrder.LITTLE_ENDIAN);
    int bytes = length.getInt();
    if (bytes < 1 || bytes > LONGEST) {
      throw new IOException("a frame says that it has " + Integer.toUnsignedString(bytes) + " bytes; from 1 to "
          + LONGEST + " are taken");
    }
    ByteBuffer frame = ByteBuffer.wrap(exactly(in, bytes)).order(ByteOrder.LITTLE_ENDIAN);
    try {
      BrokerMessage message = new BrokerReader(frame).message();
      if (frame.hasRemaining()) {
        throw new IOException("a frame has " + frame.remaining() + " bytes too many");
      }
      return message;
    } catch (BufferUnderflowException e) {
      throw new IOException("a frame is shorter than what is in it says", e);
    }
  }

  @Override
  public byte[] bytes(BrokerMessage message) {
    return BrokerWriter.bytes(message);
  }

  /** What is not there yet is not allocated: a stream gives its bytes in pieces. */
  private static byte[] exactly(InputStream in, int length) throws IOException {
    byte[] bytes = in.readNBytes(length);
    if (bytes.length < length) {
      throw new EOFException("the link ended");
    }
    return bytes;
  }
}
