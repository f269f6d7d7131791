package org.robotui.message.ros.sensor_msgs;

import org.robotui.message.MessageType;

/**
 * Kind of a satellite fix ({@code sensor_msgs/NavSatStatus}).
 *
 * @param status one of the constants {@code STATUS_...}
 * @param service sum of the constants {@code SERVICE_...}
 */
@MessageType("sensor_msgs/NavSatStatus")
public record NavSatStatus(int status, int service) {

  /** The constant {@code STATUS_NO_FIX} of the definition. */
  public static final int STATUS_NO_FIX = -1;
  /** The constant {@code STATUS_FIX} of the definition. */
  public static final int STATUS_FIX = 0;
  /** The constant {@code STATUS_SBAS_FIX} of the definition. */
  public static final int STATUS_SBAS_FIX = 1;
  /** The constant {@code STATUS_GBAS_FIX} of the definition. */
  public static final int STATUS_GBAS_FIX = 2;
  /** The constant {@code SERVICE_GPS} of the definition. */
  public static final int SERVICE_GPS = 1;
  /** The constant {@code SERVICE_GLONASS} of the definition. */
  public static final int SERVICE_GLONASS = 2;
  /** The constant {@code SERVICE_COMPASS} of the definition. */
  public static final int SERVICE_COMPASS = 4;
  /** The constant {@code SERVICE_GALILEO} of the definition. */
  public static final int SERVICE_GALILEO = 8;
}
