package org.robotui.message;

import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Writes messages in CDR, version 1: in the encoding of ROS 2, with four bytes of encapsulation before the first field,
 * or without. Not for use by several threads at once.
 */
public final class CdrWriter extends BlockWriter {

  private static final int CAPACITY = 256;

  private final boolean littleEndian;
  private final int header;

  /** Creates a writer for little-endian messages, which holds the encapsulation only. */
  public CdrWriter() {
    this(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * Creates a writer that holds the encapsulation only.
   *
   * @param order of the bytes of a number
   */
  public CdrWriter(ByteOrder order) {
    this(order, CdrReader.HEADER);
  }

  private CdrWriter(ByteOrder order, int header) {
    super(CAPACITY, order);
    this.littleEndian = order == ByteOrder.LITTLE_ENDIAN;
    this.header = header;
    encapsulation();
  }

  /**
   * Creates a writer of bytes without encapsulation, as ACE takes them.
   *
   * @param order of the bytes of a number
   * @return empty
   */
  public static CdrWriter plain(ByteOrder order) {
    return new CdrWriter(order, 0);
  }

  private void encapsulation() {
    if (header > 0) {
      u8(0).u8(littleEndian ? 1 : 0).u8(0).u8(0);
    }
  }

  @Override
  public CdrWriter string(String value) {
    byte[] utf8 = value.getBytes(StandardCharsets.UTF_8);
    array(utf8.length + 1).bytes(utf8, 0, utf8.length).u8(0);
    return this;
  }

  @Override
  public CdrWriter wstring(String value) {
    array(value.length() * Character.BYTES);
    value.chars().forEach(this::i16);
    return this;
  }

  /** Forgets all but an encapsulation and keeps the capacity. */
  @Override
  public void clear() {
    super.clear();
    encapsulation();
  }

  @Override
  int gap(int end, int size) {
    return -(end - header) & size - 1;
  }
}
