package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A part of an image ({@code sensor_msgs/RegionOfInterest}).
 *
 * @param xOffset   leftmost column
 * @param yOffset   topmost row
 * @param height    rows
 * @param width     columns
 * @param doRectify whether a distinct rectified region is to be computed
 */
public record RegionOfInterest(long xOffset, long yOffset, long height, long width, boolean doRectify) {

  /** Between records and bytes. */
  public static final RecordCodec<RegionOfInterest> CODEC =
      RecordCodec.of("sensor_msgs/RegionOfInterest", RegionOfInterest::read, RegionOfInterest::write);

  private static RegionOfInterest read(MessageReader in) throws MessageException {
    return new RegionOfInterest(
        in.uint32("x_offset"),
        in.uint32("y_offset"),
        in.uint32("height"),
        in.uint32("width"),
        in.bool("do_rectify"));
  }

  private static void write(RegionOfInterest m, MessageWriter out) {
    out.i32((int) m.xOffset);
    out.i32((int) m.yOffset);
    out.i32((int) m.height);
    out.i32((int) m.width);
    out.bool(m.doRectify);
  }
}
