package org.robotui.message;

import java.lang.invoke.MethodHandles;
import java.nio.ByteBuffer;
import java.util.Optional;

/**
 * The codec of a message type that a Java record holds, made from the type's definition.
 *
 * @param <T> the record that holds a message
 */
public final class RecordCodec<T extends Record> implements MessageCodec<T> {

  /** What comes of a record depends on its class alone. */
  private static final ClassValue<Shipped> SHIPPED = new ClassValue<>() {
    @Override
    protected Shipped computeValue(Class<?> type) {
      return new Shipped(type.asSubclass(Record.class));
    }
  };

  /** Binds a record when it is first asked for, once: the threads of many robots ask at the same time. */
  private static final class Shipped {

    private final Class<? extends Record> type;
    private RecordCodec<?> codec;

    Shipped(Class<? extends Record> type) {
      this.type = type;
    }

    synchronized RecordCodec<?> codec() {
      if (codec == null) {
        codec = new RecordCodec<>(type, ShippedDefinitions.schema(typeOf(type)), MethodHandles.publicLookup());
      }
      return codec;
    }
  }

  private final Class<T> type;
  private final MessageSchema schema;
  private final MethodHandles.Lookup lookup;
  private final RecordBinding<T> binding;

  private RecordCodec(Class<T> type, MessageSchema schema, MethodHandles.Lookup lookup) {
    this.type = type;
    this.schema = schema;
    this.lookup = lookup;
    this.binding = RecordBinding.of(type, schema, Encoding.ROS1, lookup);
  }

  /**
   * The codec of a shipped type.
   *
   * @param type a public record with a {@link MessageType}
   * @param <T> the record
   * @return the codec
   * @throws IllegalArgumentException if no definition of the type is shipped, or the record does not fit to it
   */
  @SuppressWarnings("unchecked")
  public static <T extends Record> RecordCodec<T> of(Class<T> type) {
    return (RecordCodec<T>) SHIPPED.get(type).codec();
  }

  /**
   * The codec of any type whose definition is known.
   *
   * @param type a record
   * @param schema the type of message
   * @param lookup may make and read the record, such as {@code MethodHandles.lookup()}
   * @param <T> the record
   * @return the codec
   * @throws IllegalArgumentException if the record does not fit to the definition
   */
  public static <T extends Record> RecordCodec<T> of(Class<T> type, MessageSchema schema, MethodHandles.Lookup lookup) {
    return new RecordCodec<>(type, schema, lookup);
  }

  /**
   * Joins the codecs of a shipped service type.
   *
   * @param type the full name
   * @param request a record of the request
   * @param response a record of the response
   * @param <Q> the record of the request
   * @param <R> the record of the response
   * @return the codec, with the sum of the whole service
   */
  public static <Q extends Record, R extends Record> ServiceCodec<Q, R> service(
      String type, Class<Q> request, Class<R> response) {
    RecordCodec<Q> asks = of(request);
    RecordCodec<R> answers = of(response);
    return new ServiceCodec<>(type, Md5.ofService(asks.schema, answers.schema), asks, answers);
  }

  /**
   * The type of message that a record holds.
   *
   * @param type a record with a {@link MessageType}
   * @return the full name
   * @throws IllegalArgumentException if it has none
   */
  public static String typeOf(Class<?> type) {
    Optional<MessageType> named = Optional.ofNullable(type.getAnnotation(MessageType.class));
    if (named.isEmpty()) {
      throw new IllegalArgumentException(type.getName() + " has no @MessageType");
    }
    return named.get().value();
  }

  @Override
  public MessageInfo info() {
    return schema.info();
  }

  @Override
  public T decode(ByteBuffer in) throws MessageException {
    return decode(in, binding);
  }

  T decode(ByteBuffer in, RecordBinding<T> version) throws MessageException {
    MessageReader bytes = new MessageReader(in);
    T value = version.read(bytes);
    bytes.end();
    return value;
  }

  RecordBinding<T> version(MessageSchema other) {
    return RecordBinding.ofVersion(type, schema, other, Encoding.ROS1, lookup);
  }

  @Override
  public void encode(T value, MessageWriter out) {
    binding.write(value, out);
  }

  /**
   * A message as one whose fields are read by their names.
   *
   * @param value the message
   * @return the same in the serialization of ROS 1
   */
  public DynamicMessage message(T value) {
    MessageWriter out = new MessageWriter();
    encode(value, out);
    try {
      return DynamicMessage.check(schema.layout(), out.view());
    } catch (MessageException e) {
      throw new IllegalStateException("what was written as " + info().type() + " cannot be read", e);
    }
  }
}
