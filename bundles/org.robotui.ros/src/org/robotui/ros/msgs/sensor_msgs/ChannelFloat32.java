package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * One value for each point of a {@link PointCloud} ({@code sensor_msgs/ChannelFloat32}).
 *
 * @param name   what the values are, such as {@code intensity}
 * @param values in the order of the points
 */
public record ChannelFloat32(String name, float[] values) {

  /** Between records and bytes. */
  public static final RecordCodec<ChannelFloat32> CODEC =
      RecordCodec.of("sensor_msgs/ChannelFloat32", ChannelFloat32::read, ChannelFloat32::write);

  private static ChannelFloat32 read(MessageReader in) throws MessageException {
    return new ChannelFloat32(in.string("name"), in.floats("values", in.count("values", 4)));
  }

  private static void write(ChannelFloat32 m, MessageWriter out) {
    out.string(m.name);
    out.array(m.values.length).floats(m.values);
  }
}
