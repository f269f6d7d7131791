package org.robotui.rfic.lcm.internal.convert;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import org.robotui.lcm.type.Dimension;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.LcmValue;
import org.robotui.lcm.type.MemberDefinition;
import org.robotui.lcm.type.Primitive;
import org.robotui.lcm.type.RecordBuilder;
import org.robotui.lcm.type.TypeLibrary;

/** Makes messages of named values: Boolean, Number, String, List and Map. What is not given is zero or empty. */
public final class RecordFiller {
  /** An element that is not given. */
  private static final Object NOTHING = new Object();

  private final TypeLibrary types;

  /**
   * A filler.
   *
   * @param types all types
   */
  public RecordFiller(TypeLibrary types) {
    this.types = types;
  }

  /**
   * Fills a message in.
   *
   * @param type its type
   * @param fields its members by name
   * @return the message
   * @throws IllegalArgumentException where a member does not exist or cannot hold what is given; the message names it
   */
  public LcmRecord fill(LcmType type, Map<?, ?> fields) {
    RecordBuilder builder = type.builder();
    for (Map.Entry<?, ?> field : fields.entrySet()) {
      MemberDefinition member =
          type.definition().members().stream().filter(m -> m.name().equals(field.getKey())).findFirst()
              .orElseThrow(
                  () -> new IllegalArgumentException(type.name() + " has no member '" + field.getKey() + "'; it has "
                      + type.definition().members().stream().map(MemberDefinition::name).toList()));
      set(builder, type, member, field.getValue());
    }
    return builder.build();
  }

  private void set(RecordBuilder builder, LcmType type, MemberDefinition member, Object value) {
    if (member.isArray()) {
      array(builder, type, member, value);
    } else {
      builder.set(member.name(), single(type, member, value));
    }
  }

  private LcmValue single(LcmType type, MemberDefinition member, Object value) {
    return switch (value) {
      case Boolean b -> new LcmValue.Flag(b);
      case String s -> new LcmValue.Text(s);
      case Map<?, ?> m -> new LcmValue.Nested(fill(struct(type, member), m));
      case Number n when isWhole(member) -> new LcmValue.Whole(whole(type, member, n));
      case Number n when Primitive.of(member.type()).filter(p -> p == Primitive.BOOLEAN)
          .isPresent() -> new LcmValue.Flag(n.doubleValue() != 0);
      case Number n -> new LcmValue.Real(n.doubleValue());
      default -> throw new IllegalArgumentException(
          type.name() + "." + member.name() + " is declared as '" + member + "' and cannot hold " + value);
    };
  }

  private boolean isWhole(MemberDefinition member) {
    return Primitive.of(member.type()).map(p -> p.isInteger() || p == Primitive.BYTE)
        .orElseGet(() -> types.type(member.type()).isEmpty());
  }

  private static long whole(LcmType type, MemberDefinition member, Number number) {
    boolean exact =
        number instanceof Long || number instanceof Integer || number instanceof Short || number instanceof Byte;
    double value = number.doubleValue();
    if (!exact && (value != Math.rint(value) || Math.abs(value) > 1L << 53)) {
      throw new IllegalArgumentException(
          type.name() + "." + member.name() + " is declared as '" + member + "' and cannot hold " + number);
    }
    return number.longValue();
  }

  private LcmType struct(LcmType type, MemberDefinition member) {
    return types.type(member.type()).orElseThrow(() -> new IllegalArgumentException(
        type.name() + "." + member.name() + " is declared as '" + member + "' and has no members of its own"));
  }

  private void array(RecordBuilder builder, LcmType type, MemberDefinition member, Object value) {
    List<Object> values = new ArrayList<>();
    List<Integer> shape = new ArrayList<>();
    flatten(type, member, list(type, member, value, 0), 0, shape, values);
    for (int i = 0; i < shape.size(); i++) {
      if (member.dimensions().get(i) instanceof Dimension.Variable size) {
        builder.whole(size.text(), shape.get(i));
      }
    }
    elements(builder, type, member, values);
  }

  private void elements(RecordBuilder builder, LcmType type, MemberDefinition member, List<Object> values) {
    switch (Primitive.of(member.type()).orElse(null)) {
      case null -> builder.records(member.name(), values.stream()
          .map(v -> ((LcmValue.Nested) single(type, member, v == NOTHING ? Map.of() : v)).value()).toList());
      case STRING -> builder.texts(member.name(), values.stream().map(v -> v == NOTHING ? "" : v.toString()).toList());
      case FLOAT, DOUBLE -> builder.numbers(member.name(),
          values.stream().mapToDouble(v -> number(type, member, v).doubleValue()).toArray());
      case Primitive whole -> builder.bytes(member.name(), bytes(type, member, whole, values));
    }
  }

  private static ByteBuffer bytes(LcmType type, MemberDefinition member, Primitive primitive, List<Object> values) {
    ByteBuffer bytes = ByteBuffer.allocate(Math.multiplyExact(values.size(), primitive.size()));
    for (Object value : values) {
      long number = whole(type, member, number(type, member, value));
      long low = -1L << primitive.size() * Byte.SIZE - 1;
      boolean fits = primitive == Primitive.BYTE || primitive == Primitive.BOOLEAN ? number >= 0 && number <= 0xff
          : number >= low && number <= ~low;
      if (!fits) {
        throw new IllegalArgumentException(
            type.name() + "." + member.name() + " is declared as '" + member + "' and cannot hold " + number);
      }
      switch (primitive.size()) {
        case Byte.BYTES -> bytes.put((byte) number);
        case Short.BYTES -> bytes.putShort((short) number);
        case Integer.BYTES -> bytes.putInt((int) number);
        default -> bytes.putLong(number);
      }
    }
    return bytes.flip();
  }

  private static Number number(LcmType type, MemberDefinition member, Object value) {
    return switch (value) {
      case Number n -> n;
      case Boolean b -> b ? 1 : 0;
      case Object nothing when nothing == NOTHING -> 0;
      default -> throw new IllegalArgumentException(
          type.name() + "." + member.name() + " is declared as '" + member + "' and cannot hold " + value);
    };
  }

  /** A list, or elements by index, which leave others zero. */
  private static List<?> list(LcmType type, MemberDefinition member, Object value, int dimension) {
    if (value instanceof List<?> list) {
      return list;
    }
    if (value instanceof double[] numbers) {
      return Arrays.stream(numbers).boxed().toList();
    }
    if (value instanceof SortedMap<?, ?> byIndex && !byIndex.isEmpty() && byIndex.firstKey() instanceof Integer) {
      int size = member.dimensions().get(dimension) instanceof Dimension.Fixed fixed ? fixed.size()
          : (Integer) byIndex.lastKey() + 1;
      if ((Integer) byIndex.lastKey() >= size) {
        throw new IllegalArgumentException(type.name() + "." + member.name() + " is declared as '" + member
            + "' and has no element " + byIndex.lastKey());
      }
      List<Object> list = new ArrayList<>(Collections.nCopies(size, NOTHING));
      byIndex.forEach((index, element) -> list.set((Integer) index, element));
      return list;
    }
    throw new IllegalArgumentException(type.name() + "." + member.name() + " is declared as '" + member
        + "' and cannot hold " + value + "; give a list");
  }

  private static void flatten(LcmType type, MemberDefinition member, List<?> list, int dimension, List<Integer> shape,
      List<Object> into) {
    if (shape.size() <= dimension) {
      shape.add(list.size());
    } else if (shape.get(dimension) != list.size()) {
      throw new IllegalArgumentException(type.name() + "." + member.name() + ": its rows differ in length, "
          + shape.get(dimension) + " and " + list.size());
    }
    for (Object element : list) {
      if (dimension + 1 < member.dimensions().size()) {
        flatten(type, member, list(type, member, element, dimension + 1), dimension + 1, shape, into);
      } else {
        into.add(element);
      }
    }
  }
}
