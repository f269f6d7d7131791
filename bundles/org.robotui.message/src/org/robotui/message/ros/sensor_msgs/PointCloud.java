package org.robotui.message.ros.sensor_msgs;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.Point32;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Points with optional channels: the older type, still used for sonars ({@code sensor_msgs/PointCloud}).
 *
 * @param header time and frame
 * @param points the points
 * @param channels further values of the points
 */
@MessageType("sensor_msgs/PointCloud")
public record PointCloud(Header header, List<Point32> points, List<ChannelFloat32> channels) {

  /** Keeps immutable copies of lists. */
  public PointCloud {
    points = List.copyOf(points);
    channels = List.copyOf(channels);
  }
}
