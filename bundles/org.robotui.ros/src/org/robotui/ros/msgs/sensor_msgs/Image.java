package org.robotui.ros.msgs.sensor_msgs;

import java.nio.ByteBuffer;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * An uncompressed image ({@code sensor_msgs/Image}).
 *
 * @param header      time of exposure and optical frame
 * @param height      rows
 * @param width       columns
 * @param encoding    meaning of the bytes, such as {@code rgb8}
 * @param isBigendian whether numbers of more than a byte are big-endian, 0 or 1
 * @param step        bytes of a row
 * @param data        {@code step * height} bytes
 */
public record Image(
    Header header, long height, long width, String encoding, int isBigendian, long step, ByteBuffer data) {

  /** Between records and bytes. */
  public static final RecordCodec<Image> CODEC =
      RecordCodec.of("sensor_msgs/Image", Image::read, Image::write);

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

  private static Image read(MessageReader in) throws MessageException {
    return new Image(
        in.nested("header", Header.CODEC),
        in.uint32("height"),
        in.uint32("width"),
        in.string("encoding"),
        in.uint8("is_bigendian"),
        in.uint32("step"),
        in.bytes("data"));
  }

  private static void write(Image m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.i32((int) m.height);
    out.i32((int) m.width);
    out.string(m.encoding);
    out.u8(m.isBigendian);
    out.i32((int) m.step);
    out.array(m.data.remaining()).bytes(m.data);
  }
}
