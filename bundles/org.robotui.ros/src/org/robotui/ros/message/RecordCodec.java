package org.robotui.ros.message;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Objects;

/**
 * A compiled codec of a shipped message type: a pair of functions that read and write the fields in order.
 *
 * @param <T> the record that holds a message
 */
public final class RecordCodec<T> implements MessageCodec<T> {

  /**
   * Reads the fields of one message.
   *
   * @param <T> the record
   */
  @FunctionalInterface
  public interface FieldReader<T> {
    /**
     * Reads all fields.
     *
     * @param in positioned at the first field
     * @return the record
     * @throws MessageException if the bytes are no such message
     */
    T read(MessageReader in) throws MessageException;
  }

  /**
   * Writes the fields of one message.
   *
   * @param <T> the record
   */
  @FunctionalInterface
  public interface FieldWriter<T> {
    /**
     * Writes all fields.
     *
     * @param value the record
     * @param out   where the bytes go
     */
    void write(T value, MessageWriter out);
  }

  private final MessageSchema schema;
  private final FieldReader<T> reader;
  private final FieldWriter<T> writer;

  private RecordCodec(MessageSchema schema, FieldReader<T> reader, FieldWriter<T> writer) {
    this.schema = schema;
    this.reader = reader;
    this.writer = writer;
  }

  /**
   * Creates the codec of a shipped type.
   *
   * @param type   the full name
   * @param reader reads the fields
   * @param writer writes the fields
   * @param <T>    the record
   * @return the codec
   * @throws IllegalArgumentException if no definition of the type is shipped
   */
  public static <T> RecordCodec<T> of(String type, FieldReader<T> reader, FieldWriter<T> writer) {
    return new RecordCodec<>(ShippedDefinitions.schema(type), Objects.requireNonNull(reader),
        Objects.requireNonNull(writer));
  }

  /**
   * Joins the codecs of a shipped service type.
   *
   * @param type     the full name
   * @param request  of the request
   * @param response of the response
   * @param <Q>      the record of the request
   * @param <R>      the record of the response
   * @return the codec, with the sum of the whole service
   */
  public static <Q, R> ServiceCodec<Q, R> service(String type, RecordCodec<Q> request, RecordCodec<R> response) {
    return new ServiceCodec<>(type, Md5.ofService(request.schema, response.schema), request, response);
  }

  /**
   * Checks the length of an array that the definition fixes.
   *
   * @param field    for the error
   * @param actual   the length
   * @param expected the definition's length
   * @throws IllegalArgumentException if they differ
   */
  public static void requireLength(String field, int actual, int expected) {
    if (actual != expected) {
      throw new IllegalArgumentException(field + " has " + expected + " values, not " + actual);
    }
  }

  @Override
  public MessageInfo info() {
    return schema.info();
  }

  @Override
  public T decode(ByteBuffer in) throws MessageException {
    MessageReader bytes = new MessageReader(in);
    T value = reader.read(bytes);
    bytes.end();
    return value;
  }

  @Override
  public void encode(T value, MessageWriter out) {
    writer.write(value, out);
  }

  /**
   * Writes messages as an array of variable length.
   *
   * @param values the messages
   * @param out    where the count and the messages go
   */
  public void encodeAll(List<T> values, MessageWriter out) {
    out.array(values.size());
    for (T each : values) {
      writer.write(each, out);
    }
  }

  T read(MessageReader in) throws MessageException {
    return reader.read(in);
  }

  long minSize() {
    return schema.minSize();
  }
}
