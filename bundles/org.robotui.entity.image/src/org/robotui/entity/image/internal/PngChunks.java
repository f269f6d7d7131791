package org.robotui.entity.image.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.data.array.Bytes;

/** Looks whether the chunks of a PNG are as long as they say, before a decoder takes memory for them. */
final class PngChunks {
  private static final long SIGNATURE = 0x89504e470d0a1a0aL;
  private static final int OVERHEAD = 12;
  private static final int END = 0x49454e44;

  private PngChunks() {}

  static void check(Bytes file) throws IOException {
    ByteBuffer bytes = file.buffer(ByteOrder.BIG_ENDIAN);
    if (bytes.remaining() < Long.BYTES || bytes.getLong() != SIGNATURE) {
      return;
    }
    while (bytes.remaining() >= OVERHEAD) {
      int length = bytes.getInt();
      if (length < 0 || length > bytes.remaining() - 2 * Integer.BYTES) {
        throw new IOException(
            "a part of " + Integer.toUnsignedString(length) + " bytes where " + bytes.remaining() + " are left");
      }
      if (bytes.getInt() == END) {
        return;
      }
      bytes.position(bytes.position() + length + Integer.BYTES);
    }
    throw new IOException("the data end too early");
  }
}
