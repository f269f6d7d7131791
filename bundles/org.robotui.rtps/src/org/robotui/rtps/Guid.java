package org.robotui.rtps;

import java.nio.ByteBuffer;

/**
 * Names one entity in the whole domain: a participant, a writer or a reader.
 *
 * @param prefix which participant
 * @param entity which entity of it
 */
public record Guid(GuidPrefix prefix, EntityId entity) implements Comparable<Guid> {

  /** How many bytes it has. */
  public static final int BYTES = 16;

  /** No entity. */
  public static final Guid UNKNOWN = new Guid(GuidPrefix.UNKNOWN, EntityId.UNKNOWN);

  /**
   * The participant with a prefix.
   *
   * @param prefix which participant
   * @return its own GUID
   */
  public static Guid participant(GuidPrefix prefix) {
    return new Guid(prefix, EntityId.PARTICIPANT);
  }

  /**
   * Reads the sixteen bytes of a GUID.
   *
   * @param bytes at least sixteen from its position on, which stays; its byte order does not matter
   * @return the GUID
   * @throws IllegalArgumentException if there are fewer
   */
  public static Guid of(ByteBuffer bytes) {
    if (bytes.remaining() < BYTES) {
      throw new IllegalArgumentException("a GUID has 16 bytes, here are " + bytes.remaining());
    }
    ByteBuffer view = bytes.duplicate();
    return new Guid(new GuidPrefix(view.getLong(), view.getInt()), new EntityId(view.getInt()));
  }

  /**
   * Its participant.
   *
   * @return the GUID of the participant that it belongs to
   */
  public Guid participant() {
    return participant(prefix);
  }

  /**
   * Its sixteen bytes.
   *
   * @return new bytes
   */
  public byte[] bytes() {
    return ByteBuffer.allocate(BYTES).putLong(prefix.high()).putInt(prefix.low()).putInt(entity.value()).array();
  }

  @Override
  public int compareTo(Guid other) {
    int first = prefix.compareTo(other.prefix);
    return first != 0 ? first : entity.compareTo(other.entity);
  }

  /** As ROS 2 and the tools of the vendors write it: {@code prefix|entity}. */
  @Override
  public String toString() {
    return prefix + "|" + entity;
  }
}
