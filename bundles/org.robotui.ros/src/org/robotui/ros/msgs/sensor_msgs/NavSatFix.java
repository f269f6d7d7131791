package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A position from satellites, on the WGS 84 ellipsoid ({@code sensor_msgs/NavSatFix}).
 *
 * @param header                 time and frame of the antenna
 * @param status                 kind of the fix
 * @param latitude               degrees, north is positive
 * @param longitude              degrees, east is positive
 * @param altitude               metres above the ellipsoid, NaN if not known
 * @param positionCovariance     3 x 3 east, north, up in square metres, row by row
 * @param positionCovarianceType one of the constants {@code COVARIANCE_TYPE_...}
 */
public record NavSatFix(
    Header header, NavSatStatus status, double latitude, double longitude, double altitude, double[]
    positionCovariance, int positionCovarianceType) {

  /** The constant {@code COVARIANCE_TYPE_UNKNOWN} of the definition. */
  public static final int COVARIANCE_TYPE_UNKNOWN = 0;
  /** The constant {@code COVARIANCE_TYPE_APPROXIMATED} of the definition. */
  public static final int COVARIANCE_TYPE_APPROXIMATED = 1;
  /** The constant {@code COVARIANCE_TYPE_DIAGONAL_KNOWN} of the definition. */
  public static final int COVARIANCE_TYPE_DIAGONAL_KNOWN = 2;
  /** The constant {@code COVARIANCE_TYPE_KNOWN} of the definition. */
  public static final int COVARIANCE_TYPE_KNOWN = 3;

  /** Between records and bytes. */
  public static final RecordCodec<NavSatFix> CODEC =
      RecordCodec.of("sensor_msgs/NavSatFix", NavSatFix::read, NavSatFix::write);

  /** Checks the lengths of fixed arrays. */
  public NavSatFix {
    RecordCodec.requireLength("position_covariance", positionCovariance.length, 9);
  }

  private static NavSatFix read(MessageReader in) throws MessageException {
    return new NavSatFix(
        in.nested("header", Header.CODEC),
        in.nested("status", NavSatStatus.CODEC),
        in.float64("latitude"),
        in.float64("longitude"),
        in.float64("altitude"),
        in.doubles("position_covariance", 9),
        in.uint8("position_covariance_type"));
  }

  private static void write(NavSatFix m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    NavSatStatus.CODEC.encode(m.status, out);
    out.f64(m.latitude);
    out.f64(m.longitude);
    out.f64(m.altitude);
    out.doubles(m.positionCovariance);
    out.u8(m.positionCovarianceType);
  }
}
