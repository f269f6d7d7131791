package org.robotui.ros.msgs.geometry_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A closed outline ({@code geometry_msgs/Polygon}).
 *
 * @param points its corners in order
 */
public record Polygon(List<Point32> points) {

  /** Between records and bytes. */
  public static final RecordCodec<Polygon> CODEC =
      RecordCodec.of("geometry_msgs/Polygon", Polygon::read, Polygon::write);

  /** Keeps immutable copies of lists. */
  public Polygon {
    points = List.copyOf(points);
  }

  private static Polygon read(MessageReader in) throws MessageException {
    return new Polygon(in.list("points", Point32.CODEC));
  }

  private static void write(Polygon m, MessageWriter out) {
    Point32.CODEC.encodeAll(m.points, out);
  }
}
