package org.robotui.message;

import java.nio.ByteBuffer;
import java.util.Objects;

/** Decodes messages of any type by the definition that the publisher announces. */
public final class AnyCodec implements MessageCodec<DynamicMessage> {

  private final MessageRegistry registry;

  /**
   * Creates the codec.
   *
   * @param registry remembers the types
   */
  public AnyCodec(MessageRegistry registry) {
    this.registry = Objects.requireNonNull(registry, "registry");
  }

  @Override
  public MessageInfo info() {
    return MessageInfo.any();
  }

  /**
   * Fails, as nothing tells the type.
   *
   * @throws MessageException always
   */
  @Override
  public DynamicMessage decode(ByteBuffer in) throws MessageException {
    throw new MessageException("the publisher announced no type", "", 0);
  }

  @Override
  public DynamicMessage decode(ByteBuffer in, MessageInfo peer) throws MessageException {
    return switch (registry.learn(peer)) {
      case SchemaLookup.Found<MessageSchema> found -> DynamicMessage.check(found.schema().layout(), in);
      case SchemaLookup.Missing<MessageSchema> missing -> throw new MessageException(missing.reason(), "", 0);
    };
  }

  @Override
  public void encode(DynamicMessage value, MessageWriter out) {
    out.bytes(value.bytes());
  }
}
