package org.robotui.entity.gps;

/**
 * The shortest way between two places (Vincenty's formula; between places nearly opposite on the earth, of a sphere).
 *
 * @param distance metres
 * @param bearing at the first place, radians from north over east, 0 to a full turn
 */
public record Geodesic(double distance, double bearing) {
  private static final int ROUNDS = 100;
  private static final double EXACT = 1e-12;
  private static final double FULL_TURN = 2 * Math.PI;

  /**
   * From one place to another.
   *
   * @param from the first
   * @param to the second
   * @return distance and bearing; both 0 where they are the same
   */
  public static Geodesic between(GeoPoint from, GeoPoint to) {
    double wanted = Math.IEEEremainder(to.longitude() - from.longitude(), FULL_TURN);
    double u1 = Math.atan((1 - Earth.FLATTENING) * Math.tan(from.latitude()));
    double u2 = Math.atan((1 - Earth.FLATTENING) * Math.tan(to.latitude()));
    double lambda = wanted;
    for (int i = 0; i < ROUNDS; i++) {
      Arc arc = Arc.of(u1, u2, lambda);
      if (arc.sinSigma == 0) {
        return new Geodesic(0, 0);
      }
      double next = wanted + arc.bulge();
      if (Math.abs(next - lambda) < EXACT) {
        return new Geodesic(arc.length(), arc.bearing(u1, u2, next));
      }
      lambda = next;
    }
    return sphere(from, to, wanted);
  }

  /** One round of the formula: the arc on the auxiliary sphere. */
  private record Arc(double sinSigma, double cosSigma, double sigma, double sinAlpha, double cos2Alpha,
      double cosMiddle) {
    static Arc of(double u1, double u2, double lambda) {
      double a = Math.cos(u2) * Math.sin(lambda);
      double b = Math.cos(u1) * Math.sin(u2) - Math.sin(u1) * Math.cos(u2) * Math.cos(lambda);
      double sin = Math.hypot(a, b);
      double cos = Math.sin(u1) * Math.sin(u2) + Math.cos(u1) * Math.cos(u2) * Math.cos(lambda);
      double sinAlpha = sin == 0 ? 0 : Math.cos(u1) * Math.cos(u2) * Math.sin(lambda) / sin;
      double cos2Alpha = 1 - sinAlpha * sinAlpha;
      double middle = cos2Alpha < 1e-15 ? 0 : cos - 2 * Math.sin(u1) * Math.sin(u2) / cos2Alpha;
      return new Arc(sin, cos, Math.atan2(sin, cos), sinAlpha, cos2Alpha, middle);
    }

    double bulge() {
      double f = Earth.FLATTENING;
      double c = f / 16 * cos2Alpha * (4 + f * (4 - 3 * cos2Alpha));
      return (1 - c) * f * sinAlpha
          * (sigma + c * sinSigma * (cosMiddle + c * cosSigma * (2 * cosMiddle * cosMiddle - 1)));
    }

    double length() {
      double u = cos2Alpha * (Earth.EQUATOR * Earth.EQUATOR - Earth.POLE * Earth.POLE) / (Earth.POLE * Earth.POLE);
      double a = 1 + u / 16384 * (4096 + u * (-768 + u * (320 - 175 * u)));
      double b = u / 1024 * (256 + u * (-128 + u * (74 - 47 * u)));
      double middle2 = cosMiddle * cosMiddle;
      double correction = b * sinSigma * (cosMiddle + b / 4 * (cosSigma * (2 * middle2 - 1)
          - b / 6 * cosMiddle * (4 * sinSigma * sinSigma - 3) * (4 * middle2 - 3)));
      return Earth.POLE * a * (sigma - correction);
    }

    double bearing(double u1, double u2, double lambda) {
      double east = Math.cos(u2) * Math.sin(lambda);
      double north = Math.cos(u1) * Math.sin(u2) - Math.sin(u1) * Math.cos(u2) * Math.cos(lambda);
      return turn(Math.atan2(east, north));
    }
  }

  private static Geodesic sphere(GeoPoint from, GeoPoint to, double lambda) {
    double lat1 = from.latitude();
    double lat2 = to.latitude();
    double east = Math.cos(lat2) * Math.sin(lambda);
    double north = Math.cos(lat1) * Math.sin(lat2) - Math.sin(lat1) * Math.cos(lat2) * Math.cos(lambda);
    double cos = Math.sin(lat1) * Math.sin(lat2) + Math.cos(lat1) * Math.cos(lat2) * Math.cos(lambda);
    return new Geodesic(Earth.MEAN * Math.atan2(Math.hypot(east, north), cos), turn(Math.atan2(east, north)));
  }

  private static double turn(double angle) {
    double positive = angle < 0 ? angle + FULL_TURN : angle;
    return positive >= FULL_TURN ? 0 : positive;
  }
}
