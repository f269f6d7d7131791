package org.robotui.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A message of a type known only by its definition. It keeps the checked bytes and decodes a field when asked for it,
 * so that it costs nothing to receive a large message of which one number is shown. The bytes are those of ROS 1, which
 * have no gaps; a message of another encoding is carried over when it is read. Immutable.
 */
public final class DynamicMessage {

  private final Layout layout;
  private final ByteBuffer bytes;

  private DynamicMessage(Layout layout, ByteBuffer bytes) {
    this.layout = layout;
    this.bytes = bytes;
  }

  /** Checks all lengths of a whole message and keeps a view of it. */
  static DynamicMessage check(Layout layout, ByteBuffer in) throws MessageException {
    ByteBuffer bytes = in.slice().asReadOnlyBuffer().order(ByteOrder.LITTLE_ENDIAN);
    new LayoutWalk(bytes).check(layout);
    return new DynamicMessage(layout, bytes);
  }

  /**
   * Reads a message of any encoding.
   *
   * @param schema the type of message
   * @param in of the message's encoding, at its first field
   * @return the message
   * @throws MessageException if the bytes are no message of this type
   */
  public static DynamicMessage read(MessageSchema schema, FieldReader in) throws MessageException {
    MessageWriter packed = new MessageWriter();
    new Transcoder(in, packed).message(schema.layout());
    in.end();
    return new DynamicMessage(schema.layout(), packed.view().asReadOnlyBuffer().order(ByteOrder.LITTLE_ENDIAN));
  }

  /**
   * Writes this message in any encoding.
   *
   * @param out of the encoding
   */
  public void write(FieldWriter out) {
    try {
      new Transcoder(new MessageReader(bytes()), out).message(layout);
    } catch (MessageException e) {
      throw new IllegalStateException("a checked message changed", e);
    }
  }

  /** A message inside another one that was checked. */
  static DynamicMessage at(Layout layout, ByteBuffer outer, int start) {
    try {
      int end = new LayoutWalk(outer).skip(layout, start);
      return new DynamicMessage(layout, outer.slice(start, end - start).order(ByteOrder.LITTLE_ENDIAN));
    } catch (MessageException e) {
      throw new IllegalStateException("a checked message changed", e);
    }
  }

  /**
   * The message type.
   *
   * @return the full name
   */
  public String type() {
    return layout.type();
  }

  /**
   * The fields.
   *
   * @return in the order of the definition
   */
  public List<FieldDefinition> fields() {
    return layout.fields().stream().map(f -> new FieldDefinition(f.type(), f.name(), f.initial())).toList();
  }

  /**
   * The message in the serialization of ROS 1.
   *
   * @return a read-only little-endian view
   */
  public ByteBuffer bytes() {
    return bytes.duplicate().order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * One field of this message.
   *
   * @param name its name
   * @return empty if there is no such field
   */
  public Optional<RosValue> field(String name) {
    int at = 0;
    try {
      LayoutWalk walk = new LayoutWalk(bytes);
      for (Layout.Field each : layout.fields()) {
        if (each.name().equals(name)) {
          return Optional.of(value(each, at));
        }
        at = walk.skip(each, at);
      }
      return Optional.empty();
    } catch (MessageException e) {
      throw new IllegalStateException("a checked message changed", e);
    }
  }

  /**
   * The value at a path.
   *
   * @param path such as {@code pose.pose.position.x}, {@code ranges[3]} or {@code header.stamp.secs}
   * @return empty if the path leads nowhere in this message
   */
  public Optional<RosValue> at(String path) {
    return ValuePath.follow(this, path);
  }

  /**
   * The number at a path: bools as 0 or 1, times in seconds.
   *
   * @param path as for {@link #at}
   * @return empty if there is nothing or no number
   */
  public OptionalDouble number(String path) {
    return at(path).map(DynamicMessage::asNumber).orElse(OptionalDouble.empty());
  }

  /**
   * The text at a path.
   *
   * @param path as for {@link #at}
   * @return empty if there is nothing or no text
   */
  public Optional<String> text(String path) {
    return at(path).filter(RosValue.Text.class::isInstance).map(v -> ((RosValue.Text) v).value());
  }

  Layout layout() {
    return layout;
  }

  private static OptionalDouble asNumber(RosValue value) {
    return switch (value) {
      case RosValue.Flag f -> OptionalDouble.of(f.value() ? 1 : 0);
      case RosValue.Whole w -> OptionalDouble.of(PrimitiveArray.wholeAsDouble(w));
      case RosValue.Real r -> OptionalDouble.of(r.value());
      case RosValue.Instant t -> OptionalDouble.of(t.nanos() * 1e-9);
      default -> OptionalDouble.empty();
    };
  }

  private RosValue value(Layout.Field field, int at) throws MessageException {
    return field.type().isArray() ? arrayValue(field, at) : singleValue(field, at);
  }

  private RosValue singleValue(Layout.Field field, int at) {
    if (field.nested() != null) {
      return new RosValue.Nested(at(field.nested(), bytes, at));
    }
    return field.primitive().isText()
        ? new RosValue.Text(LazyList.text(bytes, at))
        : PrimitiveArray.valueAt(field.primitive(), bytes, at);
  }

  private RosValue arrayValue(Layout.Field field, int at) throws MessageException {
    if (field.nested() != null) {
      return new RosValue.Messages(LazyList.messages(field, bytes, at));
    }
    if (field.primitive().isText()) {
      return new RosValue.Texts(LazyList.texts(field, bytes, at));
    }
    LayoutWalk walk = new LayoutWalk(bytes);
    int length = walk.count(field, at) * (int) field.element();
    return new RosValue.Numbers(
        new PrimitiveArray(field.primitive(), bytes.slice(walk.firstElement(field, at), length)));
  }

  /**
   * Equal when type and bytes are.
   */
  @Override
  public boolean equals(Object other) {
    return other instanceof DynamicMessage message
        && layout.type().equals(message.layout.type()) && bytes.equals(message.bytes);
  }

  @Override
  public int hashCode() {
    return bytes.hashCode();
  }

  @Override
  public String toString() {
    return layout.type() + " of " + bytes.limit() + " bytes";
  }
}
