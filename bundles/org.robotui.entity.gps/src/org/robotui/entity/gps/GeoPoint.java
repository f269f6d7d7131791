package org.robotui.entity.gps;

import java.util.Optional;
import org.robotui.data.sensor.GpsFix;

/**
 * A place on the ellipsoid of WGS 84.
 *
 * @param latitude radians, north is positive
 * @param longitude radians, east is positive, above -pi up to pi
 */
public record GeoPoint(double latitude, double longitude) {
  /**
   * Brings the longitude into its range.
   *
   * @param latitude radians, within a quarter turn
   * @param longitude radians, any finite number
   */
  public GeoPoint {
    if (!(Math.abs(latitude) <= Math.PI / 2 + 1e-9) || !Double.isFinite(longitude)) {
      throw new IllegalArgumentException("no place: latitude " + latitude + ", longitude " + longitude);
    }
    latitude = Math.clamp(latitude, -Math.PI / 2, Math.PI / 2);
    double turned = Math.IEEEremainder(longitude, 2 * Math.PI);
    longitude = turned <= -Math.PI ? Math.PI : turned;
  }

  /**
   * From degrees.
   *
   * @param latitude degrees
   * @param longitude degrees
   * @return the place
   */
  public static GeoPoint degrees(double latitude, double longitude) {
    return new GeoPoint(Math.toRadians(latitude), Math.toRadians(longitude));
  }

  /**
   * Where a receiver believes to be.
   *
   * @param fix what it says
   * @return the place, or none where it has none
   */
  public static Optional<GeoPoint> of(GpsFix fix) {
    boolean known =
        fix.quality() != GpsFix.Quality.NO_FIX && Double.isFinite(fix.latitude()) && Double.isFinite(fix.longitude());
    return known ? Optional.of(new GeoPoint(fix.latitude(), fix.longitude())) : Optional.empty();
  }
}
