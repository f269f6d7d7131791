package org.robotui.rfic.ros2.internal.convert;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageForm;
import org.robotui.message.data.MessageRecord;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.Ros2Codec;

/**
 * Reads the messages of one topic, each by the version of its type that its publisher announces. Safe for all threads.
 *
 * @param <M> the Java value of a message
 */
public final class VersionedReading<M> {
  /** Publishers of one topic have one or two. */
  private static final int MOST = 16;

  private final TypeName name;
  private final MessageForm<M> form;
  private final TypeLookups lookups;
  private final Optional<Ros2Codec<?>> shipped;
  private final Map<Optional<TypeHash>, Ros2Codec<?>> codecs = new ConcurrentHashMap<>();

  /**
   * Has met no publisher yet.
   *
   * @param name the type
   * @param form what its messages are read as
   * @param lookups finds versions that are not shipped
   */
  public VersionedReading(TypeName name, MessageForm<M> form, TypeLookups lookups) {
    this.name = name;
    this.form = form;
    this.lookups = lookups;
    this.shipped = shipped(form);
  }

  private static Optional<Ros2Codec<?>> shipped(MessageForm<?> form) {
    if (!(form instanceof MessageForm.Bound<?> bound)) {
      return Optional.empty();
    }
    try {
      return Optional.of(Ros2Codec.of(bound.type()));
    } catch (IllegalArgumentException e) {
      return Optional.empty(); // a type that only ROS 1 has here: the robot's definition decides
    }
  }

  /**
   * How a version is read. Does not wait.
   *
   * @param hash the sum that a publisher announced
   * @return the codec, or why there is none; empty while the version is looked for
   */
  public Optional<SchemaLookup<Ros2Codec<?>>> codec(Optional<TypeHash> hash) {
    Ros2Codec<?> known = codecs.get(hash);
    if (known != null) {
      return Optional.of(new SchemaLookup.Found<>(known));
    }
    if (codecs.size() >= MOST) {
      return Optional.of(new SchemaLookup.Missing<>("more than " + MOST + " versions of " + name + " were met"));
    }
    if (shipped.filter(own -> hash.isEmpty() || own.hash().equals(hash)).isPresent()) {
      codecs.put(hash, shipped.get());
      return Optional.of(new SchemaLookup.Found<>(shipped.get()));
    }
    return lookups.find(name, hash).map(lookup -> switch (lookup) {
      case SchemaLookup.Found<MessageSchema> found -> bind(hash, found.schema());
      case SchemaLookup.Missing<MessageSchema> missing -> new SchemaLookup.Missing<>(missing.reason());
    });
  }

  private SchemaLookup<Ros2Codec<?>> bind(Optional<TypeHash> hash, MessageSchema version) {
    try {
      Ros2Codec<?> codec = made(version);
      codecs.put(hash, codec);
      return new SchemaLookup.Found<>(codec);
    } catch (IllegalArgumentException e) {
      return new SchemaLookup.Missing<>("the robot's version of " + name + " cannot be read: " + e.getMessage());
    }
  }

  private Ros2Codec<?> made(MessageSchema version) {
    return switch (form) {
      case MessageForm.Bound<?> bound -> Ros2Codec.of(bound.type(), name, version);
      case MessageForm.Dynamic any -> Ros2Codec.of(name, version);
      case MessageForm.ByFields any -> Ros2Codec.of(name, version);
    };
  }

  /**
   * Reads a message. Does not wait.
   *
   * @param bytes the whole message with its encapsulation
   * @param hash the sum that its publisher announced
   * @return the message
   * @throws MessageException where it cannot be read, or its version is not known yet
   */
  public M read(ByteBuffer bytes, Optional<TypeHash> hash) throws MessageException {
    SchemaLookup<Ros2Codec<?>> codec = codec(hash)
        .orElseGet(() -> new SchemaLookup.Missing<>("the definition of " + name + " is being looked for"));
    return switch (codec) {
      case SchemaLookup.Found<Ros2Codec<?>> found -> value(found.schema().decode(bytes));
      case SchemaLookup.Missing<Ros2Codec<?>> missing -> throw new MessageException(missing.reason(), "", 0);
    };
  }

  @SuppressWarnings("unchecked") // the messages of each form are of its own type
  private M value(Object message) {
    return (M) (form instanceof MessageForm.ByFields ? new MessageRecord((DynamicMessage) message) : message);
  }
}
