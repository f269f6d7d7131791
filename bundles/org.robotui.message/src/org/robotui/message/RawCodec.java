package org.robotui.message;

import java.nio.ByteBuffer;
import java.util.Objects;

/** Passes messages of any type through unchanged. */
public final class RawCodec implements MessageCodec<RawMessage> {

  private final MessageInfo info;

  /** Creates a codec that accepts every type. */
  public RawCodec() {
    this(MessageInfo.any());
  }

  /**
   * Creates a codec for one type, for publishers that must announce what they send.
   *
   * @param info the identity to announce
   */
  public RawCodec(MessageInfo info) {
    this.info = Objects.requireNonNull(info, "info");
  }

  @Override
  public MessageInfo info() {
    return info;
  }

  @Override
  public RawMessage decode(ByteBuffer in) {
    return new RawMessage(info, in.slice());
  }

  @Override
  public RawMessage decode(ByteBuffer in, MessageInfo peer) {
    return new RawMessage(peer, in.slice());
  }

  @Override
  public void encode(RawMessage value, MessageWriter out) {
    out.bytes(value.bytes());
  }
}
