package org.robotui.message.ros.sensor_msgs;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * A position from satellites, on the WGS 84 ellipsoid ({@code sensor_msgs/NavSatFix}).
 *
 * @param header time and frame of the antenna
 * @param status kind of the fix
 * @param latitude degrees, north is positive
 * @param longitude degrees, east is positive
 * @param altitude metres above the ellipsoid, NaN if not known
 * @param positionCovariance 3 x 3 east, north, up in square metres, row by row
 * @param positionCovarianceType one of the constants {@code COVARIANCE_TYPE_...}
 */
@MessageType("sensor_msgs/NavSatFix")
public record NavSatFix(
    Header header, NavSatStatus status, double latitude, double longitude, double altitude, double[] positionCovariance,
    int positionCovarianceType) {

  /** The constant {@code COVARIANCE_TYPE_UNKNOWN} of the definition. */
  public static final int COVARIANCE_TYPE_UNKNOWN = 0;
  /** The constant {@code COVARIANCE_TYPE_APPROXIMATED} of the definition. */
  public static final int COVARIANCE_TYPE_APPROXIMATED = 1;
  /** The constant {@code COVARIANCE_TYPE_DIAGONAL_KNOWN} of the definition. */
  public static final int COVARIANCE_TYPE_DIAGONAL_KNOWN = 2;
  /** The constant {@code COVARIANCE_TYPE_KNOWN} of the definition. */
  public static final int COVARIANCE_TYPE_KNOWN = 3;
}
