package org.robotui.player.wire;

import java.nio.ByteBuffer;
import java.util.Objects;

/**
 * One message as it is on the wire.
 *
 * @param device which device it is from or for
 * @param type what it is for
 * @param subtype which of the interface's messages of that type, 0 to 255
 * @param stamp when it was measured, seconds by the server's clock; clients send 0
 * @param sequence the number of a request, repeated by the server's own answers; drivers and data have 0
 * @param payload the body in XDR, read only, position 0
 */
public record PlayerMessage(DeviceAddress device, MessageType type, int subtype, double stamp, long sequence,
    ByteBuffer payload) {

  /** The most bytes of a message with its header. */
  public static final int MAX_BYTES = 8 * 1024 * 1024;

  /** The bytes of a header. */
  public static final int HEADER_BYTES = 40;

  /** The bytes of the server's greeting. */
  public static final int BANNER_BYTES = 32;

  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0).asReadOnlyBuffer();

  /** Keeps a read-only view of the body. */
  public PlayerMessage {
    Objects.requireNonNull(device, "device");
    Objects.requireNonNull(type, "type");
    payload = payload.slice().asReadOnlyBuffer();
  }

  /**
   * A message without a body.
   *
   * @param device which device it is for
   * @param type what it is for
   * @param subtype which message
   * @return the message, with stamp and sequence 0
   */
  public static PlayerMessage empty(DeviceAddress device, MessageType type, int subtype) {
    return new PlayerMessage(device, type, subtype, 0, 0, NOTHING);
  }

  /**
   * A message with a body.
   *
   * @param device which device it is for
   * @param type what it is for
   * @param subtype which message
   * @param payload the body
   * @return the message, with stamp and sequence 0
   */
  public static PlayerMessage of(DeviceAddress device, MessageType type, int subtype, ByteBuffer payload) {
    return new PlayerMessage(device, type, subtype, 0, 0, payload);
  }

  /**
   * The same message with another number.
   *
   * @param number the sequence number
   * @return the message
   */
  public PlayerMessage withSequence(long number) {
    return new PlayerMessage(device, type, subtype, stamp, number, payload);
  }

  /**
   * The same message at another time.
   *
   * @param seconds the stamp
   * @return the message
   */
  public PlayerMessage withStamp(double seconds) {
    return new PlayerMessage(device, type, subtype, seconds, sequence, payload);
  }

  /**
   * The body.
   *
   * @return a view of its own, read only, position 0
   */
  @Override
  public ByteBuffer payload() {
    return payload.duplicate();
  }

  @Override
  public String toString() {
    return type + " " + subtype + " of " + device + ", " + payload.remaining() + " bytes";
  }
}
