package org.robotui.sim.internal.swarm;

import java.nio.ByteBuffer;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.nav_msgs.MapMetaData;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;

/** Gives the map of the hall. */
final class HallMap {
  private static final double RESOLUTION = 0.1;
  private static final int WALL = 3;
  private static final byte OCCUPIED = 100;

  private HallMap() {}

  /** Until the node ends. */
  static void publish(RosNode node, Hall hall, long stamp) {
    Publisher<OccupancyGrid> map =
        node.publisher("/map", RecordCodec.of(OccupancyGrid.class), PublisherOptions.latched());
    map.publish(map(hall, stamp));
  }

  private static OccupancyGrid map(Hall hall, long stamp) {
    int width = (int) Math.round(hall.width() / RESOLUTION) + 2 * WALL;
    int height = (int) Math.round(Hall.HEIGHT / RESOLUTION) + 2 * WALL;
    ByteBuffer cells = ByteBuffer.allocate(width * height);
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        boolean free = hall.isFree((column - WALL + 0.5) * RESOLUTION, (row - WALL + 0.5) * RESOLUTION, 0);
        cells.put(free ? 0 : OCCUPIED);
      }
    }
    Pose origin = new Pose(new Point(-WALL * RESOLUTION, -WALL * RESOLUTION, 0), new Quaternion(0, 0, 0, 1));
    return new OccupancyGrid(new Header(0, stamp, "map"),
        new MapMetaData(stamp, (float) RESOLUTION, width, height, origin), cells.flip());
  }
}
