package org.robotui.message;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Objects;
import org.robotui.net.collection.LruMap;

/**
 * Reads a type in whatever version the publisher speaks, by the names of the fields. Fields that the other version
 * lacks are zero or empty, those that ours lacks are left out. For types whose definition has grown over the years, so
 * that old robots and old recordings are understood.
 *
 * @param <T> the record that holds a message
 */
public final class VersionTolerantCodec<T extends Record> implements MessageCodec<T> {

  private static final int MAX_VERSIONS = 16;

  private final RecordCodec<T> codec;
  private final MessageRegistry registry;
  private final MessageInfo info;
  private final Map<MessageSchema, RecordBinding<T>> versions = new LruMap<>(MAX_VERSIONS);

  /**
   * Wraps a codec.
   *
   * @param codec reads one version
   * @param registry remembers the others
   */
  public VersionTolerantCodec(RecordCodec<T> codec, MessageRegistry registry) {
    this.codec = Objects.requireNonNull(codec, "codec");
    this.registry = Objects.requireNonNull(registry, "registry");
    this.info = new MessageInfo(codec.info().type(), MessageInfo.ANY, codec.info().definition());
  }

  /** The type of the codec, in any version. */
  @Override
  public MessageInfo info() {
    return info;
  }

  @Override
  public T decode(ByteBuffer in) throws MessageException {
    return codec.decode(in);
  }

  @Override
  public T decode(ByteBuffer in, MessageInfo peer) throws MessageException {
    if (codec.info().accepts(peer.md5())) {
      return codec.decode(in, peer);
    }
    if (!peer.type().equals(codec.info().type())) {
      throw new MessageException("it is a " + peer.type() + ", not a " + codec.info().type(), "", 0);
    }
    return switch (registry.learn(peer)) {
      case SchemaLookup.Found<MessageSchema> found -> codec.decode(in, version(found.schema()));
      case SchemaLookup.Missing<MessageSchema> missing -> throw new MessageException(missing.reason(), "", 0);
    };
  }

  private RecordBinding<T> version(MessageSchema schema) throws MessageException {
    synchronized (versions) {
      try {
        return versions.computeIfAbsent(schema, codec::version);
      } catch (IllegalArgumentException e) {
        throw new MessageException(e.getMessage(), "", 0);
      }
    }
  }

  @Override
  public void encode(T value, MessageWriter out) {
    codec.encode(value, out);
  }
}
