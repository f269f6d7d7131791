package org.robotui.testkit.recorded;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Unpacks frames of lz4; sums are not checked. */
final class Lz4 {
  private static final int MAGIC = 0x184D2204;
  private static final int BLOCK_SUMS = 0x10;
  private static final int SIZE_GIVEN = 0x08;
  private static final int PLAIN = 0x80000000;
  private static final int LONGER = 15;
  private static final int SHORTEST_MATCH = 4;

  private Lz4() {}

  /** One frame, whose content is of a known size. */
  static ByteBuffer frame(ByteBuffer packed, int size) {
    ByteBuffer in = packed.order(ByteOrder.LITTLE_ENDIAN);
    if (in.getInt() != MAGIC) {
      throw new IllegalArgumentException("no frame of lz4");
    }
    int flags = in.get();
    in.get();
    in.position(in.position() + ((flags & SIZE_GIVEN) != 0 ? Long.BYTES : 0) + 1);
    ByteBuffer out = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    for (int length = in.getInt(); length != 0; length = in.getInt()) {
      ByteBuffer block = in.slice(in.position(), length & ~PLAIN);
      in.position(in.position() + block.limit() + ((flags & BLOCK_SUMS) != 0 ? Integer.BYTES : 0));
      if ((length & PLAIN) != 0) {
        out.put(block);
      } else {
        block(block.order(ByteOrder.LITTLE_ENDIAN), out);
      }
    }
    return out.flip();
  }

  /** Literals and matches, in turn; a match repeats what lies some bytes back, and may reach into itself. */
  private static void block(ByteBuffer in, ByteBuffer out) {
    while (in.hasRemaining()) {
      int token = in.get() & 0xff;
      int literals = length(token >>> 4, in);
      out.put(in.slice(in.position(), literals));
      in.position(in.position() + literals);
      if (in.hasRemaining()) {
        int back = in.getShort() & 0xffff;
        for (int left = length(token & LONGER, in) + SHORTEST_MATCH; left > 0; left--) {
          out.put(out.get(out.position() - back));
        }
      }
    }
  }

  private static int length(int start, ByteBuffer in) {
    int length = start;
    for (int more = start == LONGER ? 255 : 0; more == 255; length += more) {
      more = in.get() & 0xff;
    }
    return length;
  }
}
