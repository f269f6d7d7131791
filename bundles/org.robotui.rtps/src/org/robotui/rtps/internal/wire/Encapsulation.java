package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** The four bytes before a payload: which encoding, in which byte order. */
public enum Encapsulation {
  /** What ROS 2 sends. */
  CDR(0x0000),
  /** Parameter lists: what discovery sends. */
  PL_CDR(0x0002),
  /** The second version, types that do not grow. */
  CDR2(0x0006),
  /** The second version, types that grow at their end. */
  D_CDR2(0x0008),
  /** The second version, types whose members have numbers. */
  PL_CDR2(0x000a);

  /** How many bytes stand before a payload. */
  public static final int BYTES = 4;

  private final int value;

  Encapsulation(int value) {
    this.value = value;
  }

  /**
   * Reads the header of a payload.
   *
   * @param payload its position moves to behind the header, and its byte order becomes that of the payload
   * @return the encoding
   * @throws WireException if there is none, or none that is known
   */
  public static Encapsulation read(ByteBuffer payload) throws WireException {
    WireInput.need(payload, BYTES, "an encapsulation header");
    int kind = ParameterValue.pair(payload);
    payload.getShort(); // options, of which none changes what follows
    payload.order((kind & 1) != 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
    for (Encapsulation encoding : values()) {
      if (encoding.value == (kind & ~1)) {
        return encoding;
      }
    }
    throw new WireException("encapsulation 0x%04x".formatted(kind));
  }

  /**
   * A payload.
   *
   * @param content what stands behind the header, in the byte order of the buffer
   * @return header and content, padded to a multiple of four bytes
   */
  public ByteBuffer payload(ByteBuffer content) {
    int length = content.remaining();
    int padding = -length & 3;
    ByteBuffer all = ByteBuffer.allocate(BYTES + length + padding);
    WireOutput.pair(all, value | (content.order() == ByteOrder.LITTLE_ENDIAN ? 1 : 0));
    WireOutput.pair(all, this == CDR || this == PL_CDR ? 0 : padding);
    return all.put(content.duplicate()).rewind().order(content.order());
  }
}
