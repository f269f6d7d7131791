package org.robotui.message;

import java.lang.invoke.MethodHandles;
import java.nio.ByteBuffer;
import java.util.function.Supplier;

/**
 * A Java record that holds the messages of a type, in one encoding. The record is compared with the definition when it
 * is bound: each component holds the field of its name ({@code frameId} holds {@code frame_id}) and must be of the type
 * that the field needs. Fields without a component are passed over, and written as zero or empty. An array of messages
 * that consist of numbers of one type, such as points, may be held as one array of those numbers. Immutable; several
 * threads may use it at once.
 *
 * @param <T> the record
 */
public final class RecordBinding<T extends Record> {

  private final Encoding encoding;
  private final BoundReader reader;
  private final Supplier<BoundWriter> writePlan;
  private volatile BoundWriter writer;

  private RecordBinding(Encoding encoding, BoundReader reader, Supplier<BoundWriter> writePlan) {
    this.encoding = encoding;
    this.reader = reader;
    this.writePlan = writePlan;
  }

  /**
   * Binds a record to its type.
   *
   * @param type the record
   * @param schema the type of message
   * @param encoding how fields become bytes
   * @param lookup may make and read the record and the records in it
   * @param <T> the record
   * @return the binding
   * @throws IllegalArgumentException if a component has no field, or one of another type, or the record is not
   * accessible
   */
  public static <T extends Record> RecordBinding<T> of(
      Class<T> type, MessageSchema schema, Encoding encoding, MethodHandles.Lookup lookup) {
    return bind(type, schema, schema, encoding, lookup);
  }

  /**
   * Binds a record to another version of its type: components that it has no field for become zero or empty.
   *
   * @param type the record
   * @param own the version that the record is made for
   * @param version the other version
   * @param encoding how fields become bytes
   * @param lookup may make and read the record and the records in it
   * @param <T> the record
   * @return the binding
   * @throws IllegalArgumentException if a component has a field of another type, or none has any
   */
  public static <T extends Record> RecordBinding<T> ofVersion(
      Class<T> type, MessageSchema own, MessageSchema version, Encoding encoding, MethodHandles.Lookup lookup) {
    BoundRecord bound = BoundRecord.of(type, version.layout(), false);
    if (bound.absent().size() == type.getRecordComponents().length && !bound.absent().isEmpty()) {
      throw new IllegalArgumentException(
          "this version of " + version.layout().type() + " has no field in common with ours");
    }
    return bind(type, own, version, encoding, lookup);
  }

  /**
   * Binds a record to the shipped definition of its type. One record is for both generations: what one of them lacks,
   * such as the counter of a header, is zero or empty, and not written.
   *
   * @param type a public record with a {@link MessageType}
   * @param generation whose definition and encoding it is bound to
   * @param <T> the record
   * @return the binding
   * @throws IllegalArgumentException if no definition of the type is shipped, or the record does not fit to it
   */
  public static <T extends Record> RecordBinding<T> shipped(Class<T> type, Generation generation) {
    String name = RecordCodec.typeOf(type);
    boolean old = new ShippedDefinitions(Generation.ROS1).has(name);
    MessageSchema own = ShippedDefinitions.schema(name, old ? Generation.ROS1 : Generation.ROS2);
    MessageSchema version = old && generation == Generation.ROS1 ? own : ShippedDefinitions.schema(name, generation);
    return ofVersion(type, own, version, generation.encoding(), MethodHandles.publicLookup());
  }

  /**
   * Binds a record of a shipped type to the version of it that a peer has.
   *
   * @param type a public record with a {@link MessageType}
   * @param version what the peer has
   * @param encoding how the peer's fields become bytes
   * @param <T> the record
   * @return the binding
   * @throws IllegalArgumentException if no definition of the type is shipped, or the record does not fit to the version
   */
  public static <T extends Record> RecordBinding<T> shipped(Class<T> type, MessageSchema version, Encoding encoding) {
    return ofVersion(type, own(RecordCodec.typeOf(type)), version, encoding, MethodHandles.publicLookup());
  }

  private static MessageSchema own(String name) {
    boolean old = new ShippedDefinitions(Generation.ROS1).has(name);
    return ShippedDefinitions.schema(name, old ? Generation.ROS1 : Generation.ROS2);
  }

  private static <T extends Record> RecordBinding<T> bind(
      Class<T> type, MessageSchema own, MessageSchema schema, Encoding encoding, MethodHandles.Lookup lookup) {
    return new RecordBinding<>(encoding,
        new ReadPlan(encoding.readerType(), lookup).of(type, schema.layout(), own.layout()),
        new Writing(type, schema, encoding, lookup));
  }

  /** How to make what writes. */
  private record Writing(Class<?> type, MessageSchema schema, Encoding encoding, MethodHandles.Lookup lookup)
      implements
      Supplier<BoundWriter> {
    @Override
    public BoundWriter get() {
      return new WritePlan(encoding.writerType(), lookup).of(type, schema.layout());
    }
  }

  /** Most records are only ever read, and a plan takes time to make. */
  private BoundWriter writing() {
    if (writer == null) {
      synchronized (this) {
        if (writer == null) {
          writer = writePlan.get();
        }
      }
    }
    return writer;
  }

  /**
   * Reads a whole message.
   *
   * @param message the message and nothing else, from position to limit; the record may keep slices of it
   * @return the record
   * @throws MessageException if the bytes are no such message, or the record refuses its values
   */
  public T decode(ByteBuffer message) throws MessageException {
    FieldReader in = encoding.reader(message);
    T value = read(in);
    in.end();
    return value;
  }

  /**
   * Writes a whole message.
   *
   * @param value the record
   * @return the message, in the byte order of the encoding
   * @throws IllegalArgumentException if an array has not the length that the definition gives
   */
  public ByteBuffer encode(T value) {
    FieldWriter out = encoding.writer();
    write(value, out);
    return out.view();
  }

  /**
   * Reads a record.
   *
   * @param in of the encoding's class, positioned at the first field
   * @return the record
   * @throws MessageException if the bytes are no such message, or the record refuses its values
   */
  @SuppressWarnings("unchecked")
  public T read(FieldReader in) throws MessageException {
    try {
      return (T) reader.read(in);
    } catch (IllegalArgumentException e) {
      throw new MessageException(String.valueOf(e.getMessage()), "", 0);
    }
  }

  /**
   * Writes a record.
   *
   * @param value the record
   * @param out of the encoding's class
   * @throws IllegalArgumentException if an array has not the length that the definition gives
   */
  public void write(T value, FieldWriter out) {
    writing().write(value, out);
  }
}
