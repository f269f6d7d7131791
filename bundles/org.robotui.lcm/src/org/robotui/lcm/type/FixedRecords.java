package org.robotui.lcm.type;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.AbstractList;
import java.util.Objects;
import java.util.RandomAccess;

/** Structs that all have the same number of bytes: each is decoded when it is asked for. */
final class FixedRecords extends AbstractList<LcmRecord> implements RandomAccess {

  private final Layout layout;
  private final ByteBuffer bytes;
  private final int count;

  FixedRecords(Layout layout, ByteBuffer bytes, int count) {
    this.layout = layout;
    this.bytes = bytes.order(ByteOrder.BIG_ENDIAN);
    this.count = count;
  }

  @Override
  public LcmRecord get(int index) {
    try {
      return RecordReader.read(layout, bytes, Objects.checkIndex(index, count) * (int) layout.minSize());
    } catch (RecordException e) {
      throw new IllegalStateException("a checked message changed", e);
    }
  }

  @Override
  public int size() {
    return count;
  }
}
