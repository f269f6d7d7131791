package org.robotui.ros.msgs.sensor_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.Point32;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Points with optional channels: the older type, still used for sonars ({@code sensor_msgs/PointCloud}).
 *
 * @param header   time and frame
 * @param points   the points
 * @param channels further values of the points
 */
public record PointCloud(Header header, List<Point32> points, List<ChannelFloat32> channels) {

  /** Between records and bytes. */
  public static final RecordCodec<PointCloud> CODEC =
      RecordCodec.of("sensor_msgs/PointCloud", PointCloud::read, PointCloud::write);

  /** Keeps immutable copies of lists. */
  public PointCloud {
    points = List.copyOf(points);
    channels = List.copyOf(channels);
  }

  private static PointCloud read(MessageReader in) throws MessageException {
    return new PointCloud(
        in.nested("header", Header.CODEC),
        in.list("points", Point32.CODEC),
        in.list("channels", ChannelFloat32.CODEC));
  }

  private static void write(PointCloud m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Point32.CODEC.encodeAll(m.points, out);
    ChannelFloat32.CODEC.encodeAll(m.channels, out);
  }
}
