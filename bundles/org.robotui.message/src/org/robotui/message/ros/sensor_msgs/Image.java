package org.robotui.message.ros.sensor_msgs;

import java.nio.ByteBuffer;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * An uncompressed image ({@code sensor_msgs/Image}).
 *
 * @param header time of exposure and optical frame
 * @param height rows
 * @param width columns
 * @param encoding meaning of the bytes, such as {@code rgb8}
 * @param isBigendian whether numbers of more than a byte are big-endian, 0 or 1
 * @param step bytes of a row
 * @param data {@code step * height} bytes
 */
@MessageType("sensor_msgs/Image")
public record Image(
    Header header, long height, long width, String encoding, int isBigendian, long step, ByteBuffer data) {

  /** Keeps read-only views of bytes. */
  public Image {
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
