package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Kind of a satellite fix ({@code sensor_msgs/NavSatStatus}).
 *
 * @param status  one of the constants {@code STATUS_...}
 * @param service sum of the constants {@code SERVICE_...}
 */
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

  /** Between records and bytes. */
  public static final RecordCodec<NavSatStatus> CODEC =
      RecordCodec.of("sensor_msgs/NavSatStatus", NavSatStatus::read, NavSatStatus::write);

  private static NavSatStatus read(MessageReader in) throws MessageException {
    return new NavSatStatus(in.int8("status"), in.uint16("service"));
  }

  private static void write(NavSatStatus m, MessageWriter out) {
    out.u8(m.status);
    out.i16(m.service);
  }
}
