package org.robotui.ros2;

import java.nio.ByteBuffer;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.message.CdrReader;
import org.robotui.message.CdrWriter;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Encoding;
import org.robotui.message.Generation;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.RecordBinding;
import org.robotui.message.RecordCodec;
import org.robotui.message.description.TypeDescription;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.internal.ShippedTypes;

/**
 * Turns the bytes of one type of ROS 2 into a Java value and back. Stateless; several threads may use it at once.
 *
 * @param <T> the Java value of a message
 */
public final class Ros2Codec<T> {

  /** Reads a message. */
  @FunctionalInterface
  private interface Decoder<T> {
    T decode(ByteBuffer in) throws MessageException;
  }

  /** What comes of a record depends on its class alone, and binding takes time. */
  private static final ClassValue<Ros2Codec<?>> SHIPPED = new ClassValue<>() {
    @Override
    protected Ros2Codec<?> computeValue(Class<?> type) {
      return shipped(type.asSubclass(Record.class));
    }
  };

  private final TypeName type;
  private final Optional<TypeHash> hash;
  private final Decoder<T> decoder;
  private final Function<T, ByteBuffer> encoder;

  private Ros2Codec(TypeName type, Optional<TypeHash> hash, Decoder<T> decoder, Function<T, ByteBuffer> encoder) {
    this.type = Objects.requireNonNull(type, "type");
    this.hash = Objects.requireNonNull(hash, "hash");
    this.decoder = decoder;
    this.encoder = encoder;
  }

  /**
   * The codec of a shipped type.
   *
   * @param type a public record with a {@link org.robotui.message.MessageType}
   * @param <T> the record
   * @return the codec, for the version of the type that is shipped
   * @throws IllegalArgumentException if no definition of the type is shipped, or the record does not fit to it
   */
  @SuppressWarnings("unchecked")
  public static <T extends Record> Ros2Codec<T> of(Class<T> type) {
    return (Ros2Codec<T>) SHIPPED.get(type);
  }

  private static <T extends Record> Ros2Codec<T> shipped(Class<T> type) {
    TypeName name = ShippedTypes.name(RecordCodec.typeOf(type));
    RecordBinding<T> binding = RecordBinding.shipped(type, Generation.ROS2);
    return new Ros2Codec<>(name, ShippedTypes.hash(name), binding::decode, binding::encode);
  }

  /**
   * The codec of a shipped type in the version that a peer has.
   *
   * @param type a public record with a {@link org.robotui.message.MessageType}
   * @param name the type's name
   * @param version what the peer has
   * @param <T> the record
   * @return the codec
   * @throws IllegalArgumentException if the record does not fit to that version
   */
  public static <T extends Record> Ros2Codec<T> of(Class<T> type, TypeName name, MessageSchema version) {
    RecordBinding<T> binding = RecordBinding.shipped(type, version, Encoding.CDR);
    return new Ros2Codec<>(name, Optional.of(TypeDescription.of(name, version).hash()), binding::decode,
        binding::encode);
  }

  /**
   * The codec of any type whose definition is known.
   *
   * @param name the type's name
   * @param schema the type
   * @return the codec; {@link org.robotui.message.DynamicCodec#build} makes messages for it
   */
  public static Ros2Codec<DynamicMessage> of(TypeName name, MessageSchema schema) {
    return new Ros2Codec<>(name, Optional.of(TypeDescription.of(name, schema).hash()),
        in -> DynamicMessage.read(schema, new CdrReader(in)), Ros2Codec::bytes);
  }

  private static ByteBuffer bytes(DynamicMessage message) {
    CdrWriter out = new CdrWriter();
    message.write(out);
    return out.view();
  }

  /**
   * Hands the bytes through, with their encapsulation. Those that are published must not change again: a publisher may
   * keep them for subscribers that ask for them later.
   *
   * @param name the type's name
   * @param hash its sum, if it is known
   * @return the codec
   */
  public static Ros2Codec<ByteBuffer> raw(TypeName name, Optional<TypeHash> hash) {
    return new Ros2Codec<>(name, hash, ByteBuffer::asReadOnlyBuffer, ByteBuffer::duplicate);
  }

  /**
   * The type.
   *
   * @return its name of three parts
   */
  public TypeName type() {
    return type;
  }

  /**
   * The sum of the type, which is announced to peers.
   *
   * @return empty if it is not known
   */
  public Optional<TypeHash> hash() {
    return hash;
  }

  /**
   * Decodes a message.
   *
   * @param in the whole message with its encapsulation, from position to limit; slices of it may be kept
   * @return the value
   * @throws MessageException if the bytes are no message of this type
   */
  public T decode(ByteBuffer in) throws MessageException {
    return decoder.decode(in);
  }

  /**
   * Encodes a message.
   *
   * @param value the value
   * @return the whole message with its encapsulation; nobody may change it
   */
  public ByteBuffer encode(T value) {
    return encoder.apply(value);
  }
}
