package org.robotui.ros.msgs.nav_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.Point;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Cells of a grid ({@code nav_msgs/GridCells}).
 *
 * @param header     time and frame
 * @param cellWidth  metres
 * @param cellHeight metres
 * @param cells      centres of the cells
 */
public record GridCells(Header header, float cellWidth, float cellHeight, List<Point> cells) {

  /** Between records and bytes. */
  public static final RecordCodec<GridCells> CODEC =
      RecordCodec.of("nav_msgs/GridCells", GridCells::read, GridCells::write);

  /** Keeps immutable copies of lists. */
  public GridCells {
    cells = List.copyOf(cells);
  }

  private static GridCells read(MessageReader in) throws MessageException {
    return new GridCells(
        in.nested("header", Header.CODEC),
        in.float32("cell_width"),
        in.float32("cell_height"),
        in.list("cells", Point.CODEC));
  }

  private static void write(GridCells m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.f32(m.cellWidth);
    out.f32(m.cellHeight);
    Point.CODEC.encodeAll(m.cells, out);
  }
}
