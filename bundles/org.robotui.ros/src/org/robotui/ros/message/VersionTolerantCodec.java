package org.robotui.ros.message;

import java.nio.ByteBuffer;
import java.util.Objects;

/**
 * Reads a type in whatever version the publisher speaks: the version of a codec by that codec, another one field by field, by name. Fields
 * that the other version lacks are zero or empty, those that ours lacks are left out. For types whose definition has grown over the years,
 * so that old robots and old recordings are understood.
 *
 * @param <T> the Java value of a message
 */
public final class VersionTolerantCodec<T> implements MessageCodec<T> {

  private final MessageCodec<T> codec;
  private final MessageRegistry registry;
  private final MessageInfo info;

  /**
   * Wraps a codec.
   *
   * @param codec    reads one version
   * @param registry remembers the others
   */
  public VersionTolerantCodec(MessageCodec<T> codec, MessageRegistry registry) {
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
    Layout theirs = layout(peer);
    DynamicMessage message = DynamicMessage.check(theirs, in);
    return codec.decode(Transcoder.transcode(message.bytes(), theirs, layout(codec.info())));
  }

  private Layout layout(MessageInfo version) throws MessageException {
    return switch (registry.learn(version)) {
      case SchemaLookup.Found<MessageSchema> found -> found.schema().layout();
      case SchemaLookup.Missing<MessageSchema> missing -> throw new MessageException(missing.reason(), "", 0);
    };
  }

  @Override
  public void encode(T value, MessageWriter out) {
    codec.encode(value, out);
  }
}
