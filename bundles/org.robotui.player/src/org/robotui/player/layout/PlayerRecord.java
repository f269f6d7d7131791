package org.robotui.player.layout;

import java.lang.reflect.Array;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/** A message's body, or a structure in it, as named values, whatever the interface. Immutable. */
public final class PlayerRecord {

  private static final Pattern STEP = Pattern.compile("(\\w+)(?:\\[(\\d{1,8})])?(?:\\.(.+))?");

  private final StructLayout struct;
  private final Object[] values;

  PlayerRecord(StructLayout struct, Object[] values) {
    this.struct = struct;
    this.values = values;
  }

  /**
   * Makes a record from plain Java values, as a form or a script gives them.
   *
   * @param struct the structure
   * @param values by field name: numbers, booleans, texts, {@code byte[]} or lists or arrays of numbers, maps for
   * structures and lists of maps; a field without a value becomes zero or empty
   * @return the record
   * @throws IllegalArgumentException if a value does not fit its field, or there is no such field
   */
  public static PlayerRecord of(StructLayout struct, Map<String, ?> values) {
    return RecordBuilder.build(struct, values);
  }

  /**
   * The body of a message that has none.
   *
   * @return a record without fields
   */
  public static PlayerRecord empty() {
    return new PlayerRecord(MessageDecoder.NOTHING, new Object[0]);
  }

  /**
   * The structure.
   *
   * @return with the names, units and meanings of the fields
   */
  public StructLayout layout() {
    return struct;
  }

  /**
   * One field.
   *
   * @param name its name
   * @return empty if there is no such field
   */
  public Optional<FieldValue> field(String name) {
    return IntStream.range(0, values.length).filter(i -> struct.fields().get(i).name().equals(name))
        .mapToObj(i -> value(values[i]))
        .findFirst();
  }

  /**
   * The value at a path.
   *
   * @param path such as {@code position.x} or {@code ranges[3]} or {@code blobs[0].area}
   * @return empty if the path leads nowhere
   */
  public Optional<FieldValue> at(String path) {
    Matcher step = STEP.matcher(path);
    if (!step.matches()) {
      return Optional.empty();
    }
    Optional<FieldValue> value = field(step.group(1));
    if (step.group(2) != null) {
      int index = Integer.parseInt(step.group(2));
      value = value.flatMap(array -> element(array, index));
    }
    String rest = step.group(3);
    return rest == null ? value
        : value.filter(FieldValue.Nested.class::isInstance)
            .flatMap(nested -> ((FieldValue.Nested) nested).value().at(rest));
  }

  /**
   * The number at a path; yes and no as 1 and 0.
   *
   * @param path as for {@link #at}
   * @return empty if there is nothing or no number
   */
  public OptionalDouble number(String path) {
    return at(path).map(PlayerRecord::asNumber).orElse(OptionalDouble.empty());
  }

  /** The values in the order of the fields: not to be changed. */
  Object[] values() {
    return values;
  }

  private static Optional<FieldValue> element(FieldValue array, int index) {
    return switch (array) {
      case FieldValue.Numbers n when index < n.values().length -> Optional.of(new FieldValue.Real(n.values()[index]));
      case FieldValue.Bytes b when index < b.value().length -> Optional
          .of(new FieldValue.Whole(b.value()[index] & 0xff));
      case FieldValue.Many m when index < m.values().size() -> Optional
          .of(new FieldValue.Nested(m.values().get(index)));
      default -> Optional.empty();
    };
  }

  private static OptionalDouble asNumber(FieldValue value) {
    return switch (value) {
      case FieldValue.Whole w -> OptionalDouble.of(w.value());
      case FieldValue.Real r -> OptionalDouble.of(r.value());
      case FieldValue.Flag f -> OptionalDouble.of(f.value() ? 1 : 0);
      default -> OptionalDouble.empty();
    };
  }

  private static FieldValue value(Object raw) {
    return switch (raw) {
      case Boolean flag -> new FieldValue.Flag(flag);
      case Float real -> new FieldValue.Real(real);
      case Double real -> new FieldValue.Real(real);
      case Number whole -> new FieldValue.Whole(whole.longValue());
      case String text -> new FieldValue.Text(text);
      case byte[] bytes -> new FieldValue.Bytes(bytes);
      case PlayerRecord record -> new FieldValue.Nested(record);
      case List<?> list -> new FieldValue.Many(list.stream().map(PlayerRecord.class::cast).toList());
      default -> new FieldValue.Numbers(numbers(raw));
    };
  }

  private static double[] numbers(Object array) {
    double[] numbers = new double[Array.getLength(array)];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = ((Number) Array.get(array, i)).doubleValue();
    }
    return numbers;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof PlayerRecord record && struct == record.struct && Arrays.deepEquals(values, record.values);
  }

  @Override
  public int hashCode() {
    return Arrays.deepHashCode(values);
  }

  @Override
  public String toString() {
    return struct.name() + " of " + values.length + " fields";
  }
}
