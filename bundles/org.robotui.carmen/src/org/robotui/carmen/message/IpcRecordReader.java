package org.robotui.carmen.message;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.robotui.carmen.format.FormatTree;
import org.robotui.carmen.format.IpcFormat;
import org.robotui.carmen.format.IpcFormatException;
import org.robotui.carmen.format.IpcPrimitive;

/** Bytes of IPC as records. */
final class IpcRecordReader {

  private final ByteBuffer in;

  private IpcRecordReader(ByteBuffer in) {
    this.in = in;
  }

  /** Reads all that is left in a buffer. */
  static IpcRecord read(IpcFormat format, List<FieldName> names, ByteBuffer in) throws IpcFormatException {
    try {
      IpcRecordReader reader = new IpcRecordReader(in);
      IpcRecord record = switch (format) {
        case IpcFormat.Nothing n -> IpcRecord.EMPTY;
        case IpcFormat.Struct s -> reader.struct(s, names);
        default -> new IpcRecord(names, List.of(reader.value(format, names.getFirst())));
      };
      if (in.hasRemaining()) {
        throw new IpcFormatException(in.remaining() + " bytes are left over behind a message of the format " + format);
      }
      return record;
    } catch (BufferUnderflowException e) {
      throw new IpcFormatException("a message ends too early for its format " + format);
    }
  }

  private IpcRecord struct(IpcFormat.Struct struct, List<FieldName> names) throws IpcFormatException {
    List<IpcValue> values = new ArrayList<>();
    List<List<Integer>> counts = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      counts.add(new ArrayList<>());
      values.add(struct.members().get(i) instanceof IpcFormat.VariableArray array
          ? variable(array, names.get(i), counts.get(i))
          : value(struct.members().get(i), names.get(i)));
    }
    for (int i = 0; i < names.size(); i++) {
      if (struct.members().get(i) instanceof IpcFormat.VariableArray array) {
        agree(array, counts.get(i), values, names.get(i));
      }
    }
    return new IpcRecord(names, values);
  }

  /** The number of elements is in the message twice: before them, and in a member of the structure. */
  private static void agree(IpcFormat.VariableArray array, List<Integer> counts, List<IpcValue> values, FieldName name)
      throws IpcFormatException {
    for (int i = 0; i < counts.size(); i++) {
      int member = array.members().get(i) - 1;
      boolean same = member >= 0 && member < values.size() && values.get(member) instanceof IpcValue.Whole w
          && w.value() == counts.get(i);
      if (!same) {
        throw new IpcFormatException(
            name.name() + " has " + counts.get(i) + " elements, and member " + (member + 1) + " says another number");
      }
    }
  }

  private IpcValue variable(IpcFormat.VariableArray array, FieldName name, List<Integer> counts)
      throws IpcFormatException {
    long count = 1;
    for (int i = 0; i < array.members().size(); i++) {
      int size = in.getInt();
      counts.add(size);
      count = size < 0 ? -1 : Math.min(count * size, Integer.MAX_VALUE);
    }
    return elements(array.element(), (int) count, name);
  }

  private IpcValue value(IpcFormat format, FieldName name) throws IpcFormatException {
    return switch (format) {
      case IpcFormat.Single s -> single(s.type());
      case IpcFormat.Struct s -> new IpcValue.Members(struct(s, name.members()));
      case IpcFormat.Pointer p -> in.get() == 0 ? new IpcValue.Absent() : value(p.target(), name);
      case IpcFormat.FixedArray a -> elements(a.element(), a.count(), name);
      case IpcFormat.Opaque o -> elements(new IpcFormat.Single(IpcPrimitive.BYTE), o.bytes(), name);
      case IpcFormat.VariableArray a -> throw new IpcFormatException(
          name.name() + " is an array whose size no structure around it says");
      case IpcFormat.Named n -> throw new IpcFormatException(
          name.name() + " has the format " + n.name() + ", of which it is not known what it consists of");
      case IpcFormat.Nothing n -> new IpcValue.Absent();
    };
  }

  private IpcValue single(IpcPrimitive type) throws IpcFormatException {
    return switch (type) {
      case INT, BOOLEAN -> new IpcValue.Whole(in.getInt());
      case BYTE, UBYTE, CHAR -> new IpcValue.Whole(in.get() & 0xff);
      case FLOAT -> new IpcValue.Small(in.getFloat());
      case DOUBLE -> new IpcValue.Real(in.getDouble());
      case STRING -> new IpcValue.Text(text(in));
      case FORMAT -> new IpcValue.Form(FormatTree.read(in));
    };
  }

  /** Behind the length of an empty text there is one byte more. */
  private static String text(ByteBuffer in) throws IpcFormatException {
    int length = in.getInt();
    if (length < 0 || length > in.remaining()) {
      throw new IpcFormatException("a text of " + length + " characters is longer than its message");
    }
    byte[] characters = new byte[length];
    in.get(characters);
    if (length == 0) {
      in.get();
    }
    return new String(characters, StandardCharsets.ISO_8859_1);
  }

  private IpcValue elements(IpcFormat element, int count, FieldName name) throws IpcFormatException {
    int most = element.leastBytes() == 0 ? 0 : in.remaining() / element.leastBytes();
    if (count < 0 || count > most) {
      throw new IpcFormatException(name.name() + " has " + count + " elements, and " + in.remaining()
          + " bytes of the message are left");
    }
    return element instanceof IpcFormat.Single single && single.type().isNumber()
        ? primitives(single.type(), count)
        : items(element, count, name);
  }

  private IpcValue primitives(IpcPrimitive type, int count) {
    ByteBuffer all = in.slice(in.position(), count * type.bytes()).order(in.order());
    in.position(in.position() + count * type.bytes());
    return switch (type) {
      case FLOAT -> {
        float[] values = new float[count];
        all.asFloatBuffer().get(values);
        yield new IpcValue.Smalls(values);
      }
      case DOUBLE -> {
        double[] values = new double[count];
        all.asDoubleBuffer().get(values);
        yield new IpcValue.Reals(values);
      }
      case INT, BOOLEAN -> {
        int[] values = new int[count];
        all.asIntBuffer().get(values);
        yield new IpcValue.Wholes(values);
      }
      default -> {
        byte[] values = new byte[count];
        all.get(values);
        yield new IpcValue.Octets(values);
      }
    };
  }

  private IpcValue items(IpcFormat element, int count, FieldName name) throws IpcFormatException {
    List<IpcValue> items = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      items.add(value(element, name));
    }
    return new IpcValue.Items(items);
  }
}
