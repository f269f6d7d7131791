package org.robotui.carmen.format;

import java.util.Arrays;
import java.util.Optional;

/** The primitive types of IPC, with the numbers by which a central sends them. Bytes are those on the wire. */
public enum IpcPrimitive {
  /** A signed number of 32 bits. */
  INT("int", 1, 4),
  /** A number of 32 bits, 0 for false. */
  BOOLEAN("boolean", 2, 4),
  /** IEEE 754 of 32 bits. */
  FLOAT("float", 3, 4),
  /** IEEE 754 of 64 bits. */
  DOUBLE("double", 4, 8),
  /** An unsigned number of 8 bits. */
  BYTE("byte", 5, 1),
  /** Characters of 8 bits behind their number. */
  STRING("string", 7, 4),
  /** A format, as a tree. */
  FORMAT("format", 8, 4),
  /** An unsigned number of 8 bits. */
  UBYTE("ubyte", 9, 1),
  /** A character of 8 bits. */
  CHAR("char", 16, 1);

  private final String word;
  private final int code;
  private final int bytes;

  IpcPrimitive(String word, int code, int bytes) {
    this.word = word;
    this.code = code;
    this.bytes = bytes;
  }

  /**
   * Its name in formats.
   *
   * @return such as {@code double}
   */
  public String word() {
    return word;
  }

  /**
   * Its number on the wire.
   *
   * @return as centrals send it
   */
  public int code() {
    return code;
  }

  /**
   * How many bytes a value has at least.
   *
   * @return all of it, but for strings
   */
  public int bytes() {
    return bytes;
  }

  /**
   * Whether a value is one byte.
   *
   * @return true for characters and bytes
   */
  public boolean isOctet() {
    return bytes == 1;
  }

  /**
   * Whether a value is a number, or a character.
   *
   * @return false for texts and formats
   */
  public boolean isNumber() {
    return this != STRING && this != FORMAT;
  }

  /**
   * The type of that name.
   *
   * @param word as in a format
   * @return empty where IPC has none of that name that was ever met
   */
  public static Optional<IpcPrimitive> named(String word) {
    return Arrays.stream(values()).filter(each -> each.word.equals(word)).findFirst();
  }

  /**
   * The type of that number.
   *
   * @param code as a central sends it
   * @return empty where it was never met
   */
  public static Optional<IpcPrimitive> coded(int code) {
    return Arrays.stream(values()).filter(each -> each.code == code).findFirst();
  }
}
