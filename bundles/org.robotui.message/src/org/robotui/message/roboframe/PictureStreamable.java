package org.robotui.message.roboframe;

import java.nio.ByteBuffer;
import org.robotui.message.MessageType;

/**
 * A compressed picture ({@code roboframe/Picture}).
 *
 * @param stamp when it was taken, nanoseconds by the clock of the application
 * @param frame the frame of the camera's optics
 * @param format jpeg or png
 * @param data the file
 */
@MessageType("roboframe/Picture")
public record PictureStreamable(long stamp, String frame, String format, ByteBuffer data) {
  /** Keeps a read-only view of the bytes. */
  public PictureStreamable {
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
