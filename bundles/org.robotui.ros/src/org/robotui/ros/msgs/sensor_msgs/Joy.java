package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * State of a joystick ({@code sensor_msgs/Joy}).
 *
 * @param header  time
 * @param axes    each from -1 to 1
 * @param buttons each 0 or 1
 */
public record Joy(Header header, float[] axes, int[] buttons) {

  /** Between records and bytes. */
  public static final RecordCodec<Joy> CODEC =
      RecordCodec.of("sensor_msgs/Joy", Joy::read, Joy::write);

  private static Joy read(MessageReader in) throws MessageException {
    return new Joy(
        in.nested("header", Header.CODEC),
        in.floats("axes", in.count("axes", 4)),
        in.ints("buttons", in.count("buttons", 4)));
  }

  private static void write(Joy m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.array(m.axes.length).floats(m.axes);
    out.array(m.buttons.length).ints(m.buttons);
  }
}
