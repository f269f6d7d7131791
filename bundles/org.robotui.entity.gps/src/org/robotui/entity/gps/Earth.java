package org.robotui.entity.gps;

/** The ellipsoid of WGS 84. */
final class Earth {
  static final double EQUATOR = 6_378_137;
  static final double FLATTENING = 1 / 298.257223563;
  static final double POLE = EQUATOR * (1 - FLATTENING);
  static final double ECCENTRICITY2 = FLATTENING * (2 - FLATTENING);
  static final double MEAN = (2 * EQUATOR + POLE) / 3;

  private Earth() {}

  /** From the middle of the earth to a place on it: x through latitude and longitude 0, z through the north pole. */
  static double[] centred(GeoPoint place) {
    double sin = Math.sin(place.latitude());
    double cos = Math.cos(place.latitude());
    double across = EQUATOR / Math.sqrt(1 - ECCENTRICITY2 * sin * sin);
    return new double[]{
        across * cos * Math.cos(place.longitude()), across * cos * Math.sin(place.longitude()),
        across * (1 - ECCENTRICITY2) * sin};
  }

  /** The place below or above a point: its height over the ellipsoid may be a hundred kilometres. */
  static GeoPoint below(double x, double y, double z) {
    double across = Math.hypot(x, y);
    double angle = Math.atan2(z * EQUATOR, across * POLE);
    for (int i = 0; i < 3; i++) {
      double sin = Math.sin(angle);
      double cos = Math.cos(angle);
      double latitude = Math.atan2(z + ECCENTRICITY2 / (1 - ECCENTRICITY2) * POLE * sin * sin * sin,
          across - ECCENTRICITY2 * EQUATOR * cos * cos * cos);
      angle = Math.atan2((1 - FLATTENING) * Math.sin(latitude), Math.cos(latitude));
    }
    double latitude = Math.atan2(Math.sin(angle), (1 - FLATTENING) * Math.cos(angle));
    return new GeoPoint(latitude, across == 0 ? 0 : Math.atan2(y, x));
  }
}
