package org.robotui.ros.msgs.nav_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.message.Stamps;
import org.robotui.ros.msgs.geometry_msgs.Pose;

/**
 * Size and place of a grid map ({@code nav_msgs/MapMetaData}).
 *
 * @param mapLoadTime when the map was loaded, nanoseconds since the epoch of the sender's clock
 * @param resolution  side of a cell, metres
 * @param width       cells
 * @param height      cells
 * @param origin      pose of the lower left corner of cell (0, 0) in the map's frame
 */
public record MapMetaData(long mapLoadTime, float resolution, long width, long height, Pose origin) {

  /** Between records and bytes. */
  public static final RecordCodec<MapMetaData> CODEC =
      RecordCodec.of("nav_msgs/MapMetaData", MapMetaData::read, MapMetaData::write);

  private static MapMetaData read(MessageReader in) throws MessageException {
    return new MapMetaData(
        in.time("map_load_time"),
        in.float32("resolution"),
        in.uint32("width"),
        in.uint32("height"),
        in.nested("origin", Pose.CODEC));
  }

  private static void write(MapMetaData m, MessageWriter out) {
    Stamps.write(m.mapLoadTime, out);
    out.f32(m.resolution);
    out.i32((int) m.width);
    out.i32((int) m.height);
    Pose.CODEC.encode(m.origin, out);
  }
}
