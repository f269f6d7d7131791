package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * One sweep of a planar laser scanner ({@code sensor_msgs/LaserScan}).
 *
 * @param header         when the first ray was taken, and the frame: rays lie in its x-y plane
 * @param angleMin       angle of the first ray, radians
 * @param angleMax       angle of the last ray, radians
 * @param angleIncrement from ray to ray, radians
 * @param timeIncrement  from ray to ray, seconds
 * @param scanTime       from sweep to sweep, seconds
 * @param rangeMin       shortest valid distance, metres
 * @param rangeMax       longest valid distance, metres
 * @param ranges         a distance for each ray, metres; outside the limits it is invalid
 * @param intensities    an echo strength for each ray in the device's unit, or empty
 */
public record LaserScan(
    Header header, float angleMin, float angleMax, float angleIncrement, float timeIncrement, float scanTime,
    float rangeMin, float rangeMax, float[] ranges, float[] intensities) {

  /** Between records and bytes. */
  public static final RecordCodec<LaserScan> CODEC =
      RecordCodec.of("sensor_msgs/LaserScan", LaserScan::read, LaserScan::write);

  private static LaserScan read(MessageReader in) throws MessageException {
    return new LaserScan(
        in.nested("header", Header.CODEC),
        in.float32("angle_min"),
        in.float32("angle_max"),
        in.float32("angle_increment"),
        in.float32("time_increment"),
        in.float32("scan_time"),
        in.float32("range_min"),
        in.float32("range_max"),
        in.floats("ranges", in.count("ranges", 4)),
        in.floats("intensities", in.count("intensities", 4)));
  }

  private static void write(LaserScan m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.f32(m.angleMin);
    out.f32(m.angleMax);
    out.f32(m.angleIncrement);
    out.f32(m.timeIncrement);
    out.f32(m.scanTime);
    out.f32(m.rangeMin);
    out.f32(m.rangeMax);
    out.array(m.ranges.length).floats(m.ranges);
    out.array(m.intensities.length).floats(m.intensities);
  }
}
