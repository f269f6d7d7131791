package org.robotui.lcm.type;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** Encodes records, whose builder has seen to it that sizes and arrays agree. */
final class RecordWriter {

  private final ByteBuffer out;

  private RecordWriter(ByteBuffer out) {
    this.out = out;
  }

  static ByteBuffer write(long fingerprint, LcmRecord record) {
    long size = Long.BYTES + size(record);
    if (size > Integer.MAX_VALUE - 8) {
      throw new IllegalArgumentException("a message of " + size + " bytes is too long");
    }
    RecordWriter writer = new RecordWriter(ByteBuffer.allocate((int) size).putLong(fingerprint));
    writer.struct(record);
    return writer.out.flip();
  }

  private static long size(LcmRecord record) {
    if (record.layout().isFixed()) {
      return record.layout().minSize();
    }
    long size = 0;
    for (int i = 0; i < record.layout().slots().size(); i++) {
      size += size(record.layout().slots().get(i), record.value(i));
    }
    return size;
  }

  private static long size(Slot slot, LcmValue value) {
    return switch (value) {
      case LcmValue.Text text -> size(text.value());
      case LcmValue.Nested nested -> size(nested.value());
      case LcmValue.Numbers numbers -> numbers.value().bytes().remaining();
      case LcmValue.Texts texts -> texts.values().stream().mapToLong(RecordWriter::size).sum();
      case LcmValue.Records records -> records.values().stream().mapToLong(RecordWriter::size).sum();
      default -> slot.elementSize();
    };
  }

  private static long size(String text) {
    return Integer.BYTES + text.getBytes(StandardCharsets.UTF_8).length + 1L;
  }

  private void struct(LcmRecord record) {
    for (int i = 0; i < record.layout().slots().size(); i++) {
      value(record.layout().slots().get(i), record.value(i));
    }
  }

  private void value(Slot slot, LcmValue value) {
    switch (value) {
      case LcmValue.Whole whole -> whole(slot.primitive().orElseThrow(), whole.value());
      case LcmValue.Real real -> real(slot.primitive().orElseThrow(), real.value());
      case LcmValue.Flag flag -> out.put((byte) (flag.value() ? 1 : 0));
      case LcmValue.Text text -> text(text.value());
      case LcmValue.Nested nested -> struct(nested.value());
      case LcmValue.Numbers numbers -> out.put(numbers.value().bytes());
      case LcmValue.Texts texts -> texts.values().forEach(this::text);
      case LcmValue.Records records -> records.values().forEach(this::struct);
    }
  }

  private void whole(Primitive type, long value) {
    switch (type) {
      case INT16 -> out.putShort((short) value);
      case INT32 -> out.putInt((int) value);
      case INT64 -> out.putLong(value);
      default -> out.put((byte) value);
    }
  }

  private void real(Primitive type, double value) {
    if (type == Primitive.FLOAT) {
      out.putFloat((float) value);
    } else {
      out.putDouble(value);
    }
  }

  private void text(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    out.putInt(bytes.length + 1).put(bytes).put((byte) 0);
  }
}
