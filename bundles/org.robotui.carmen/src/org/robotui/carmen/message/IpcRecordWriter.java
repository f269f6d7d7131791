package org.robotui.carmen.message;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.robotui.carmen.format.FormatTree;
import org.robotui.carmen.format.IpcFormat;
import org.robotui.carmen.format.IpcPrimitive;

/** Records as bytes of IPC. What does not fit its format is an {@link IllegalArgumentException}. */
final class IpcRecordWriter {

  private static final byte PRESENT = 'Z';

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteBuffer word;

  private IpcRecordWriter(ByteOrder order) {
    word = ByteBuffer.allocate(Double.BYTES).order(order);
  }

  static byte[] write(IpcFormat format, IpcRecord record, ByteOrder order) {
    IpcRecordWriter writer = new IpcRecordWriter(order);
    switch (format) {
      case IpcFormat.Nothing n -> {}
      case IpcFormat.Struct s -> writer.struct(s, record);
      default -> writer.value(format, record.values().getFirst());
    }
    return writer.out.toByteArray();
  }

  private void struct(IpcFormat.Struct struct, IpcRecord record) {
    if (struct.members().size() != record.values().size()) {
      throw new IllegalArgumentException(record.values().size() + " values are not as many as in " + struct);
    }
    for (int i = 0; i < struct.members().size(); i++) {
      if (struct.members().get(i) instanceof IpcFormat.VariableArray array) {
        variable(array, record, i);
      } else {
        value(struct.members().get(i), record.values().get(i));
      }
    }
  }

  private void variable(IpcFormat.VariableArray array, IpcRecord record, int index) {
    long count = 1;
    for (int member : array.members()) {
      IpcValue size = record.values().get(member - 1);
      if (!(size instanceof IpcValue.Whole w)) {
        throw new IllegalArgumentException(record.names().get(member - 1).name() + " is no number of elements");
      }
      whole(w.value());
      count *= w.value();
    }
    IpcValue elements = record.values().get(index);
    if (elements(array.element(), elements) != count) {
      throw new IllegalArgumentException(record.names().get(index).name() + " has not " + count + " elements");
    }
  }

  private void value(IpcFormat format, IpcValue value) {
    switch (format) {
      case IpcFormat.Single s -> single(s.type(), value);
      case IpcFormat.Struct s when value instanceof IpcValue.Members m -> struct(s, m.record());
      case IpcFormat.Pointer p -> pointer(p, value);
      case IpcFormat.FixedArray a when size(value) == a.count() -> elements(a.element(), value);
      case IpcFormat.Opaque o when size(value) == o.bytes() -> elements(new IpcFormat.Single(IpcPrimitive.BYTE), value);
      case IpcFormat.Nothing n -> {}
      default -> throw unfit(format, value);
    }
  }

  private void pointer(IpcFormat.Pointer pointer, IpcValue value) {
    boolean absent = value instanceof IpcValue.Absent;
    out.write(absent ? 0 : PRESENT);
    if (!absent) {
      value(pointer.target(), value);
    }
  }

  private void single(IpcPrimitive type, IpcValue value) {
    switch (value) {
      case IpcValue.Whole w when type.isOctet() -> out.write(w.value());
      case IpcValue.Whole w when type == IpcPrimitive.INT || type == IpcPrimitive.BOOLEAN -> whole(w.value());
      case IpcValue.Small s when type == IpcPrimitive.FLOAT -> small(s.value());
      case IpcValue.Real r when type == IpcPrimitive.DOUBLE -> real(r.value());
      case IpcValue.Text t when type == IpcPrimitive.STRING -> text(t.value());
      case IpcValue.Form f when type == IpcPrimitive.FORMAT -> out
          .writeBytes(FormatTree.bytes(f.format(), word.order()));
      default -> throw unfit(new IpcFormat.Single(type), value);
    }
  }

  private static IllegalArgumentException unfit(IpcFormat format, IpcValue value) {
    return new IllegalArgumentException(value.getClass().getSimpleName() + " is no value of the format " + format);
  }

  private static int size(IpcValue value) {
    return switch (value) {
      case IpcValue.Octets o -> o.values().length;
      case IpcValue.Wholes w -> w.values().length;
      case IpcValue.Smalls s -> s.values().length;
      case IpcValue.Reals r -> r.values().length;
      case IpcValue.Items i -> i.values().size();
      default -> -1;
    };
  }

  private int elements(IpcFormat element, IpcValue value) {
    switch (value) {
      case IpcValue.Octets o when octet(element) -> out.writeBytes(o.values());
      case IpcValue.Wholes w when is(element, IpcPrimitive.INT) || is(element, IpcPrimitive.BOOLEAN) -> wholes(w);
      case IpcValue.Smalls s when is(element, IpcPrimitive.FLOAT) -> smalls(s);
      case IpcValue.Reals r when is(element, IpcPrimitive.DOUBLE) -> reals(r);
      case IpcValue.Items items -> items(element, items.values());
      default -> throw unfit(element, value);
    }
    return size(value);
  }

  private static boolean is(IpcFormat format, IpcPrimitive type) {
    return format instanceof IpcFormat.Single single && single.type() == type;
  }

  private static boolean octet(IpcFormat format) {
    return format instanceof IpcFormat.Single single && single.type().isOctet();
  }

  private void wholes(IpcValue.Wholes array) {
    for (int value : array.values()) {
      whole(value);
    }
  }

  private void smalls(IpcValue.Smalls array) {
    for (float value : array.values()) {
      small(value);
    }
  }

  private void reals(IpcValue.Reals array) {
    for (double value : array.values()) {
      real(value);
    }
  }

  private void items(IpcFormat element, List<IpcValue> values) {
    for (IpcValue value : values) {
      value(element, value);
    }
  }

  private void whole(int value) {
    word.putInt(0, value);
    out.write(word.array(), 0, Integer.BYTES);
  }

  private void small(float value) {
    word.putFloat(0, value);
    out.write(word.array(), 0, Float.BYTES);
  }

  private void real(double value) {
    word.putDouble(0, value);
    out.write(word.array(), 0, Double.BYTES);
  }

  private void text(String text) {
    byte[] characters = text.getBytes(StandardCharsets.ISO_8859_1);
    whole(characters.length);
    out.writeBytes(characters);
    if (characters.length == 0) {
      out.write(PRESENT);
    }
  }
}
