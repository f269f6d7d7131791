package org.robotui.lcm.type;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Decodes structs. Every size is checked against the bytes that are there before anything is made for it. */
final class RecordReader {

  private static final int MOST_NESTED = 200;
  /** Structs and texts of one message that need objects of their own; those of one size are decoded when asked for. */
  private static final int MOST_OBJECTS = 1 << 18;
  /** Elements without bytes: any number of them would fit into nothing. */
  private static final int MOST_EMPTY = 1000;

  private final ByteBuffer bytes;
  private int at;
  private int depth;
  private int objects;

  private RecordReader(ByteBuffer bytes, int at) {
    this.bytes = bytes;
    this.at = at;
  }

  /** Reads a struct from bytes that start with the message. */
  static LcmRecord read(Layout layout, ByteBuffer bytes, int at) throws RecordException {
    return new RecordReader(bytes, at).struct(layout);
  }

  private LcmRecord struct(Layout layout) throws RecordException {
    if (++depth > MOST_NESTED) {
      throw new RecordException(layout.type(), "structs are nested deeper than " + MOST_NESTED, "", at);
    }
    LcmValue[] values = new LcmValue[layout.slots().size()];
    for (int i = 0; i < values.length; i++) {
      values[i] = member(layout, layout.slots().get(i), values);
    }
    depth--;
    return new LcmRecord(layout, values);
  }

  private LcmValue member(Layout layout, Slot slot, LcmValue[] before) throws RecordException {
    try {
      return slot.isArray() ? array(layout, slot, before) : single(layout, slot);
    } catch (RecordException e) {
      throw e.within(slot.name(), layout.type());
    }
  }

  private LcmValue single(Layout layout, Slot slot) throws RecordException {
    return switch (slot.element()) {
      case Slot.Struct struct -> new LcmValue.Nested(struct(struct.layout()));
      case Slot.Builtin builtin -> builtin.primitive() == Primitive.STRING ? new LcmValue.Text(text(layout))
          : number(layout, builtin.primitive());
    };
  }

  private LcmValue number(Layout layout, Primitive type) throws RecordException {
    int start = take(layout, type.size());
    return switch (type) {
      case FLOAT -> new LcmValue.Real(bytes.getFloat(start));
      case DOUBLE -> new LcmValue.Real(bytes.getDouble(start));
      case BOOLEAN -> new LcmValue.Flag(bytes.get(start) != 0);
      case INT8 -> new LcmValue.Whole(bytes.get(start));
      case BYTE -> new LcmValue.Whole(Byte.toUnsignedLong(bytes.get(start)));
      case INT16 -> new LcmValue.Whole(bytes.getShort(start));
      case INT32 -> new LcmValue.Whole(bytes.getInt(start));
      case INT64 -> new LcmValue.Whole(bytes.getLong(start));
      case STRING -> throw new IllegalStateException("a text is no number");
    };
  }

  private String text(Layout layout) throws RecordException {
    countObject(layout);
    int length = bytes.getInt(take(layout, Integer.BYTES));
    if (length < 0 || length > left()) {
      throw new RecordException(layout.type(),
          "a text of " + length + " bytes does not fit into the remaining " + left(), "", at);
    }
    int start = take(layout, length);
    byte[] text = new byte[Math.max(0, length - 1)];
    bytes.get(start, text);
    return new String(text, StandardCharsets.UTF_8);
  }

  private LcmValue array(Layout layout, Slot slot, LcmValue[] before) throws RecordException {
    List<Integer> shape = shape(layout, slot, before);
    long count = shape.stream().mapToLong(Integer::longValue).reduce(1, Slot::product);
    long room = slot.elementSize() == 0 ? MOST_EMPTY : left() / slot.elementSize();
    if (count > room) {
      throw new RecordException(layout.type(),
          "an array of " + shape + " does not fit into the remaining " + left() + " bytes", "", at);
    }
    return switch (slot.element()) {
      case Slot.Struct struct -> new LcmValue.Records(structs(struct.layout(), (int) count), shape);
      case Slot.Builtin builtin -> builtin.primitive() == Primitive.STRING
          ? new LcmValue.Texts(texts(layout, (int) count), shape)
          : new LcmValue.Numbers(numbers(layout, builtin.primitive(), (int) count, shape));
    };
  }

  private List<Integer> shape(Layout layout, Slot slot, LcmValue[] before) throws RecordException {
    List<Integer> shape = new ArrayList<>(slot.extents().size());
    for (Slot.Extent extent : slot.extents()) {
      long size = extent.isFixed() ? extent.size() : ((LcmValue.Whole) before[extent.slot()]).value();
      if (size < 0 || size > Integer.MAX_VALUE) {
        throw new RecordException(layout.type(),
            "member " + layout.slots().get(extent.slot()).name() + " says that there are " + size
                + " elements",
            "", at);
      }
      shape.add((int) size);
    }
    return shape;
  }

  private NumberArray numbers(Layout layout, Primitive type, int count, List<Integer> shape) throws RecordException {
    int length = count * type.size();
    return new NumberArray(type, bytes.slice(take(layout, length), length), shape);
  }

  private List<String> texts(Layout layout, int count) throws RecordException {
    List<String> texts = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      try {
        texts.add(text(layout));
      } catch (RecordException e) {
        throw e.within("[" + i + "]", layout.type());
      }
    }
    return texts;
  }

  private List<LcmRecord> structs(Layout layout, int count) throws RecordException {
    if (layout.isFixed()) {
      int size = (int) layout.minSize();
      return new FixedRecords(layout, bytes.slice(take(layout, count * size), count * size), count);
    }
    List<LcmRecord> records = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      countObject(layout);
      try {
        records.add(struct(layout));
      } catch (RecordException e) {
        throw e.within("[" + i + "]", layout.type());
      }
    }
    return List.copyOf(records);
  }

  private void countObject(Layout layout) throws RecordException {
    if (++objects > MOST_OBJECTS) {
      throw new RecordException(layout.type(), "more than " + MOST_OBJECTS + " texts and structs in one message", "",
          at);
    }
  }

  private int take(Layout layout, int size) throws RecordException {
    if (size > left()) {
      throw new RecordException(layout.type(), size + " bytes are needed and " + left() + " are left", "", at);
    }
    int start = at;
    at += size;
    return start;
  }

  private int left() {
    return bytes.limit() - at;
  }
}
