package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A point with time and frame ({@code geometry_msgs/PointStamped}).
 *
 * @param header time and frame
 * @param point  the point
 */
public record PointStamped(Header header, Point point) {

  /** Between records and bytes. */
  public static final RecordCodec<PointStamped> CODEC =
      RecordCodec.of("geometry_msgs/PointStamped", PointStamped::read, PointStamped::write);

  private static PointStamped read(MessageReader in) throws MessageException {
    return new PointStamped(in.nested("header", Header.CODEC), in.nested("point", Point.CODEC));
  }

  private static void write(PointStamped m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Point.CODEC.encode(m.point, out);
  }
}
