package org.robotui.rtps;

import java.util.HexFormat;

/**
 * Which entity of a participant: a key of three bytes, and a byte that says what it is.
 *
 * @param value the four bytes, the first one highest
 */
public record EntityId(int value) implements Comparable<EntityId> {

  /** No entity, or every one of a kind. */
  public static final EntityId UNKNOWN = new EntityId(0);

  /** The participant itself. */
  public static final EntityId PARTICIPANT = new EntityId(0x000001c1);

  private static final int KIND = 0x3f;

  private static final int BUILT_IN = 0xc0;

  private static final int WRITER_WITH_KEY = 0x02;

  private static final int WRITER_NO_KEY = 0x03;

  private static final int READER_NO_KEY = 0x04;

  private static final int READER_WITH_KEY = 0x07;

  /**
   * An endpoint of an application.
   *
   * @param key which one, 1 to 0xffffff
   * @param kind whether it writes or reads
   * @param keyed whether its topic has instances that keys tell apart
   * @return its id
   */
  public static EntityId user(int key, EndpointKind kind, boolean keyed) {
    if (key < 1 || key > 0xff_ffff) {
      throw new IllegalArgumentException("an entity with the key " + key);
    }
    int reader = keyed ? READER_WITH_KEY : READER_NO_KEY;
    int writer = keyed ? WRITER_WITH_KEY : WRITER_NO_KEY;
    return new EntityId(key << 8 | (kind == EndpointKind.WRITER ? writer : reader));
  }

  /**
   * Whether it is one that every participant has.
   *
   * @return true for those of discovery and the like, false for those of applications
   */
  public boolean builtIn() {
    return (value & BUILT_IN) == BUILT_IN;
  }

  /**
   * Whether it writes.
   *
   * @return true for writers
   */
  public boolean writer() {
    int kind = value & KIND;
    return kind == WRITER_WITH_KEY || kind == WRITER_NO_KEY;
  }

  /**
   * Whether it reads.
   *
   * @return true for readers
   */
  public boolean reader() {
    int kind = value & KIND;
    return kind == READER_WITH_KEY || kind == READER_NO_KEY;
  }

  /**
   * Whether its topic has keys.
   *
   * @return true if its samples belong to instances that keys tell apart
   */
  public boolean keyed() {
    int kind = value & KIND;
    return kind == WRITER_WITH_KEY || kind == READER_WITH_KEY;
  }

  @Override
  public int compareTo(EntityId other) {
    return Integer.compareUnsigned(value, other.value);
  }

  /** As the tools of the vendors write it: bytes in hexadecimal digits, with dots between them. */
  @Override
  public String toString() {
    return HexFormat.of().toHexDigits(value).replaceAll("(..)(?!$)", "$1.");
  }
}
