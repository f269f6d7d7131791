package org.robotui.ros.msgs.sensor_msgs;

import java.nio.ByteBuffer;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A compressed image ({@code sensor_msgs/CompressedImage}).
 *
 * @param header time of exposure and optical frame
 * @param format such as {@code jpeg}
 * @param data   the compressed bytes
 */
public record CompressedImage(Header header, String format, ByteBuffer data) {

  /** Between records and bytes. */
  public static final RecordCodec<CompressedImage> CODEC =
      RecordCodec.of("sensor_msgs/CompressedImage", CompressedImage::read, CompressedImage::write);

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

  private static CompressedImage read(MessageReader in) throws MessageException {
    return new CompressedImage(in.nested("header", Header.CODEC), in.string("format"), in.bytes("data"));
  }

  private static void write(CompressedImage m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.string(m.format);
    out.array(m.data.remaining()).bytes(m.data);
  }
}
