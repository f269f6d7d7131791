package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.ProtocolVersion;
import org.robotui.rtps.VendorId;

/** Packs submessages into one datagram after another, in a buffer that is used again. For one thread. */
public final class DatagramWriter {

  private static final int MAGIC = 0x52545053;

  /** What lengths of submessages can say. A longer one must be the last one, and then says zero. */
  private static final int LONGEST = 0xffff;

  private final ByteBuffer out;

  /**
   * Writes for a participant.
   *
   * @param own which one
   * @param most no datagram is longer, in bytes
   * @param order the byte order of all that it writes
   */
  public DatagramWriter(GuidPrefix own, int most, ByteOrder order) {
    out = ByteBuffer.allocateDirect(most); // a socket would copy one of the heap once more
    out.putInt(MAGIC).put((byte) ProtocolVersion.V2_3.major()).put((byte) ProtocolVersion.V2_3.minor());
    WireOutput.pair(out, VendorId.UNKNOWN.value());
    WireOutput.prefix(out, own);
    out.order(order);
  }

  /** The byte order that inline QoS must have, too. */
  public ByteOrder order() {
    return out.order();
  }

  /** Whether nothing was added since the last reset. */
  public boolean isEmpty() {
    return out.position() == DatagramReader.HEADER_BYTES;
  }

  /**
   * Adds a submessage.
   *
   * @param part what to add
   * @return false if there is no room for it, and nothing was added: finish, reset, and add it again
   * @throws IllegalArgumentException if it fits into no datagram
   */
  public boolean add(Submessage part) {
    int size = SubmessageSize.of(part);
    if (size > out.capacity() - DatagramReader.HEADER_BYTES || size - 4 > LONGEST) {
      throw new IllegalArgumentException("a submessage of %d bytes for datagrams of %d".formatted(size,
          out.capacity()));
    }
    if (size > out.remaining()) {
      return false;
    }
    int start = out.position();
    out.putInt(0);
    int flags = PartWriter.write(part, out);
    int little = out.order() == ByteOrder.LITTLE_ENDIAN ? SubmessageId.LITTLE : 0;
    out.put(start, (byte) PartWriter.id(part)).put(start + 1, (byte) (flags | little));
    out.putShort(start + 2, (short) (out.position() - start - 4));
    return true;
  }

  /**
   * The datagram.
   *
   * @return a view, good until the next reset
   */
  public ByteBuffer finish() {
    return out.duplicate().flip();
  }

  /** Begins a new datagram. */
  public void reset() {
    out.position(DatagramReader.HEADER_BYTES);
  }
}
