package org.robotui.rtps;

import java.nio.ByteBuffer;

/** Bytes that nobody can change: kept once, and shown by views of their own. */
final class UserBytes {

  private UserBytes() {}

  static ByteBuffer copy(ByteBuffer bytes) {
    ByteBuffer copy = ByteBuffer.allocate(bytes.remaining());
    return copy.put(bytes.duplicate()).flip().asReadOnlyBuffer();
  }
}
