package org.robotui.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Objects;

/**
 * A message that nobody decoded yet.
 *
 * @param info the identity the publisher announced
 * @param bytes the message's bytes without a length prefix, read only; {@link #bytes()} answers a fresh little-endian
 * view each time
 */
public record RawMessage(MessageInfo info, ByteBuffer bytes) {

  /** Keeps a read-only view of the bytes. */
  public RawMessage {
    Objects.requireNonNull(info, "info");
    bytes = bytes.asReadOnlyBuffer();
  }

  /** The message's bytes as a fresh little-endian view, from position 0 on. */
  @Override
  public ByteBuffer bytes() {
    return bytes.duplicate().order(ByteOrder.LITTLE_ENDIAN);
  }
}
