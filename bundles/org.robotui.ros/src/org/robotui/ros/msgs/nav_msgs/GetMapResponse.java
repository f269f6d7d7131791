package org.robotui.ros.msgs.nav_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * The current map ({@code nav_msgs/GetMapResponse}).
 *
 * @param map the map
 */
public record GetMapResponse(OccupancyGrid map) {

  /** Between records and bytes. */
  public static final RecordCodec<GetMapResponse> CODEC =
      RecordCodec.of("nav_msgs/GetMapResponse", GetMapResponse::read, GetMapResponse::write);

  private static GetMapResponse read(MessageReader in) throws MessageException {
    return new GetMapResponse(in.nested("map", OccupancyGrid.CODEC));
  }

  private static void write(GetMapResponse m, MessageWriter out) {
    OccupancyGrid.CODEC.encode(m.map, out);
  }
}
