package org.robotui.ros.msgs.nav_msgs;

import java.nio.ByteBuffer;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A grid map ({@code nav_msgs/OccupancyGrid}).
 *
 * @param header time and frame
 * @param info   size and place
 * @param data   row by row from the origin: 0 to 100 percent occupied, -1 unknown
 */
public record OccupancyGrid(Header header, MapMetaData info, ByteBuffer data) {

  /** Between records and bytes. */
  public static final RecordCodec<OccupancyGrid> CODEC =
      RecordCodec.of("nav_msgs/OccupancyGrid", OccupancyGrid::read, OccupancyGrid::write);

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

  private static OccupancyGrid read(MessageReader in) throws MessageException {
    return new OccupancyGrid(
        in.nested("header", Header.CODEC),
        in.nested("info", MapMetaData.CODEC),
        in.bytes("data"));
  }

  private static void write(OccupancyGrid m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    MapMetaData.CODEC.encode(m.info, out);
    out.array(m.data.remaining()).bytes(m.data);
  }
}
