package org.robotui.message.ros.nav_msgs;

import java.nio.ByteBuffer;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * A grid map ({@code nav_msgs/OccupancyGrid}).
 *
 * @param header time and frame
 * @param info size and place
 * @param data row by row from the origin: 0 to 100 percent occupied, -1 unknown
 */
@MessageType("nav_msgs/OccupancyGrid")
public record OccupancyGrid(Header header, MapMetaData info, ByteBuffer data) {

  /** Keeps read-only views of bytes. */
  public OccupancyGrid {
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
}
