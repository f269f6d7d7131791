package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * One reading of an ultrasonic or infrared sensor ({@code sensor_msgs/Range}).
 *
 * @param header        time and frame: the cone opens along x
 * @param radiationType {@link #ULTRASOUND} or {@link #INFRARED}
 * @param fieldOfView   opening angle of the cone, radians
 * @param minRange      shortest valid distance, metres
 * @param maxRange      longest valid distance, metres
 * @param range         the distance, metres
 */
public record Range(
    Header header, int radiationType, float fieldOfView, float minRange, float maxRange, float range) {

  /** The constant {@code ULTRASOUND} of the definition. */
  public static final int ULTRASOUND = 0;
  /** The constant {@code INFRARED} of the definition. */
  public static final int INFRARED = 1;

  /** Between records and bytes. */
  public static final RecordCodec<Range> CODEC =
      RecordCodec.of("sensor_msgs/Range", Range::read, Range::write);

  private static Range read(MessageReader in) throws MessageException {
    return new Range(
        in.nested("header", Header.CODEC),
        in.uint8("radiation_type"),
        in.float32("field_of_view"),
        in.float32("min_range"),
        in.float32("max_range"),
        in.float32("range"));
  }

  private static void write(Range m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.u8(m.radiationType);
    out.f32(m.fieldOfView);
    out.f32(m.minRange);
    out.f32(m.maxRange);
    out.f32(m.range);
  }
}
