package org.robotui.message;

import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Writes messages in the serialization of ROS 1: little endian, without padding. Not for use by several threads at
 * once.
 */
public final class MessageWriter extends BlockWriter {

  private static final int CAPACITY = 256;

  /** Creates an empty writer with a small capacity. */
  public MessageWriter() {
    this(CAPACITY);
  }

  /**
   * Creates an empty writer.
   *
   * @param capacity how many bytes fit before the writer grows for the first time
   */
  public MessageWriter(int capacity) {
    super(capacity, ByteOrder.LITTLE_ENDIAN);
  }

  @Override
  public MessageWriter string(String value) {
    byte[] utf8 = value.getBytes(StandardCharsets.UTF_8);
    array(utf8.length).bytes(utf8, 0, utf8.length);
    return this;
  }

  /** ROS 1 has no other texts than those of bytes. */
  @Override
  public MessageWriter wstring(String value) {
    return string(value);
  }

  @Override
  int gap(int end, int size) {
    return 0;
  }
}
