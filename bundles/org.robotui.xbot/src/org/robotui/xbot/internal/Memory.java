package org.robotui.xbot.internal;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/**
 * Reads memory that another process writes meanwhile: under a sequence lock, copied before anything in it is believed.
 */
final class Memory {
  private static final VarHandle LONGS = MethodHandles.byteBufferViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
  private static final int TRIES = 100;

  private final ByteBuffer bytes;

  /** Memory that stays mapped as long as the owner of the buffer lives. */
  Memory(ByteBuffer bytes) {
    this.bytes = bytes.asReadOnlyBuffer().order(ByteOrder.LITTLE_ENDIAN);
  }

  /** A number that its writer stores as one. */
  long acquireLong(int offset) {
    return (long) LONGS.getAcquire(bytes, offset);
  }

  /** A number that its writer wrote before anybody could read it. */
  int readInt(int offset) {
    return bytes.getInt(offset);
  }

  /** A copy that need not be consistent in itself: counters. */
  ByteBuffer copy(int offset, int size) {
    byte[] copy = new byte[size];
    bytes.get(offset, copy);
    return ByteBuffer.wrap(copy).order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * A copy of what a sequence lock guards, taken while nobody wrote it; none where the writer writes all the time, or
   * died writing.
   *
   * @param sequence where the lock's number is
   * @param offset where the data begins
   * @param size its bytes
   */
  Optional<ByteBuffer> consistent(int sequence, int offset, int size) {
    byte[] copy = new byte[size];
    return consistent(sequence, offset, copy) ? Optional.of(ByteBuffer.wrap(copy).order(ByteOrder.LITTLE_ENDIAN))
        : Optional.empty();
  }

  /** The same into an array of its size, whose content is of no use where it is false. */
  boolean consistent(int sequence, int offset, byte[] into) {
    for (int i = 0; i < TRIES; i++) {
      long before = acquireLong(sequence);
      if ((before & 1) == 0) {
        bytes.get(offset, into);
        VarHandle.acquireFence();
        if ((long) LONGS.getOpaque(bytes, sequence) == before) {
          return true;
        }
      }
      Thread.onSpinWait();
    }
    return false;
  }

  /** Text that ends with zero or with its room, whatever bytes it has. */
  static String text(ByteBuffer from, int offset, int room) {
    int length = 0;
    while (length < room && from.get(offset + length) != 0) {
      length++;
    }
    byte[] text = new byte[length];
    from.get(offset, text);
    return new String(text, StandardCharsets.UTF_8);
  }
}
