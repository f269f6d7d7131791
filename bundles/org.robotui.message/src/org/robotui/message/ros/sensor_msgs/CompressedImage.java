package org.robotui.message.ros.sensor_msgs;

import java.nio.ByteBuffer;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * A compressed image ({@code sensor_msgs/CompressedImage}).
 *
 * @param header time of exposure and optical frame
 * @param format such as {@code jpeg}
 * @param data the compressed bytes
 */
@MessageType("sensor_msgs/CompressedImage")
public record CompressedImage(Header header, String format, ByteBuffer data) {

  /** Keeps read-only views of bytes. */
  public CompressedImage {
    data = data.slice().asReadOnlyBuffer();
  }

  /**
   * The bytes, without a copy.
   *
   * @return a fresh read-only view
   */
  @Override
  public ByteBuffer data() {
    return data.duplicate();
  }
}
