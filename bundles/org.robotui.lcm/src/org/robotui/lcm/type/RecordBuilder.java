package org.robotui.lcm.type;

import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Makes a record. What is not set is zero, false or empty. Members that are sizes of arrays are set by the arrays;
 * where one is set as well, both must agree. Arrays of several dimensions are given row by row. Not for several
 * threads.
 */
public final class RecordBuilder {

  private final Layout layout;
  private final Map<Integer, LcmValue> given = new LinkedHashMap<>();

  RecordBuilder(Layout layout) {
    this.layout = layout;
  }

  /**
   * Sets an integer, or a floating point number that is whole.
   *
   * @param member its name
   * @param value the number; 0 to 255 for a {@code byte}
   * @return this
   * @throws IllegalArgumentException if the member does not exist or cannot hold the value
   */
  public RecordBuilder whole(String member, long value) {
    return set(member, new LcmValue.Whole(value));
  }

  /**
   * Sets a floating point number.
   *
   * @param member its name
   * @param value the number
   * @return this
   * @throws IllegalArgumentException if the member does not exist or cannot hold the value
   */
  public RecordBuilder real(String member, double value) {
    return set(member, new LcmValue.Real(value));
  }

  /**
   * Sets a truth value.
   *
   * @param member its name
   * @param value true or false
   * @return this
   * @throws IllegalArgumentException if the member does not exist or cannot hold the value
   */
  public RecordBuilder flag(String member, boolean value) {
    return set(member, new LcmValue.Flag(value));
  }

  /**
   * Sets a text.
   *
   * @param member its name
   * @param value the text, without a zero character
   * @return this
   * @throws IllegalArgumentException if the member does not exist or cannot hold the value
   */
  public RecordBuilder text(String member, String value) {
    return set(member, new LcmValue.Text(value));
  }

  /**
   * Sets a struct.
   *
   * @param member its name
   * @param value the struct
   * @return this
   * @throws IllegalArgumentException if the member does not exist or cannot hold the value
   */
  public RecordBuilder record(String member, LcmRecord value) {
    return set(member, new LcmValue.Nested(value));
  }

  /**
   * Sets an array of numbers.
   *
   * @param member its name
   * @param values the numbers, row by row; whole ones where the member is of integers
   * @return this
   * @throws IllegalArgumentException if the member does not exist or cannot hold the values
   */
  public RecordBuilder numbers(String member, double... values) {
    Primitive type = numberType(member);
    return set(member,
        new LcmValue.Numbers(new NumberArray(type, NumberBytes.of(type, values), List.of(values.length))));
  }

  /**
   * Sets an array of integers or truth values, as bytes where the member is of bytes.
   *
   * @param member its name
   * @param bytes the elements as they are sent: big-endian, row by row
   * @return this
   * @throws IllegalArgumentException if the member does not exist or cannot hold the values
   */
  public RecordBuilder bytes(String member, ByteBuffer bytes) {
    Primitive type = numberType(member);
    if (bytes.remaining() % type.size() != 0) {
      throw new IllegalArgumentException(
          bytes.remaining() + " bytes are no array of " + type.lcmName() + " for " + layout.type() + "." + member);
    }
    return set(member, new LcmValue.Numbers(new NumberArray(type, bytes, List.of(bytes.remaining() / type.size()))));
  }

  /**
   * Sets an array of texts.
   *
   * @param member its name
   * @param values the texts, row by row
   * @return this
   * @throws IllegalArgumentException if the member does not exist or cannot hold the values
   */
  public RecordBuilder texts(String member, List<String> values) {
    return set(member, new LcmValue.Texts(values, List.of(values.size())));
  }

  /**
   * Sets an array of structs.
   *
   * @param member its name
   * @param values the structs, row by row
   * @return this
   * @throws IllegalArgumentException if the member does not exist or cannot hold the values
   */
  public RecordBuilder records(String member, List<LcmRecord> values) {
    return set(member, new LcmValue.Records(List.copyOf(values), List.of(values.size())));
  }

  /**
   * Sets whatever the member holds.
   *
   * @param member its name
   * @param value of the member's kind
   * @return this
   * @throws IllegalArgumentException if the member does not exist or cannot hold the value
   */
  public RecordBuilder set(String member, LcmValue value) {
    int index = index(member);
    given.put(index, Fitting.of(layout.slots().get(index), value, layout.type()));
    return this;
  }

  /**
   * Makes the record.
   *
   * @return the record
   * @throws IllegalArgumentException if sizes and arrays do not agree; the message names them
   */
  public LcmRecord build() {
    return new RecordAssembly(layout, given).build();
  }

  private int index(String member) {
    int index = layout.indexOf(member);
    if (index < 0) {
      throw new IllegalArgumentException(layout.type() + " has no member '" + member + "', but "
          + layout.slots().stream().map(Slot::name).toList());
    }
    return index;
  }

  private Primitive numberType(String member) {
    Slot slot = layout.slots().get(index(member));
    return slot.primitive().filter(type -> type != Primitive.STRING)
        .orElseThrow(() -> new IllegalArgumentException(
            layout.type() + "." + member + " is no array of numbers, but " + slot.member()));
  }
}
