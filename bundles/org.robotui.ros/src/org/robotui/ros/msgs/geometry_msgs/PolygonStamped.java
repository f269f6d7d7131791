package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * An outline with time and frame ({@code geometry_msgs/PolygonStamped}).
 *
 * @param header  time and frame
 * @param polygon the outline
 */
public record PolygonStamped(Header header, Polygon polygon) {

  /** Between records and bytes. */
  public static final RecordCodec<PolygonStamped> CODEC =
      RecordCodec.of("geometry_msgs/PolygonStamped", PolygonStamped::read, PolygonStamped::write);

  private static PolygonStamped read(MessageReader in) throws MessageException {
    return new PolygonStamped(in.nested("header", Header.CODEC), in.nested("polygon", Polygon.CODEC));
  }

  private static void write(PolygonStamped m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Polygon.CODEC.encode(m.polygon, out);
  }
}
