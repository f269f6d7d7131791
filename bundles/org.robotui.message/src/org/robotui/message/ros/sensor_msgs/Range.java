package org.robotui.message.ros.sensor_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * One reading of an ultrasonic or infrared sensor ({@code sensor_msgs/Range}).
 *
 * @param header time and frame: the cone opens along x
 * @param radiationType {@link #ULTRASOUND} or {@link #INFRARED}
 * @param fieldOfView opening angle of the cone, radians
 * @param minRange shortest valid distance, metres
 * @param maxRange longest valid distance, metres
 * @param range the distance, metres
 */
@MessageType("sensor_msgs/Range")
public record Range(
    Header header, int radiationType, float fieldOfView, float minRange, float maxRange, float range) {

  /** The constant {@code ULTRASOUND} of the definition. */
  public static final int ULTRASOUND = 0;
  /** The constant {@code INFRARED} of the definition. */
  public static final int INFRARED = 1;
}
