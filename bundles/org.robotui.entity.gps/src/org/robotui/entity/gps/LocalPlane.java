package org.robotui.entity.gps;

import java.util.Optional;

/**
 * A plane that touches the earth at an origin: x east, y north, metres. Also at the poles and across the antimeridian.
 * A distance of 10 km is 4 mm too short on it, one of 100 km 4 m.
 *
 * @param origin where it touches
 */
public record LocalPlane(GeoPoint origin) {
  /** Places farther from the origin than this are not on the plane, metres. */
  public static final double REACH = 500_000;

  private static final int ROUNDS = 12;

  /**
   * A point of the plane.
   *
   * @param east metres
   * @param north metres
   */
  public record Point(double east, double north) {}

  /**
   * Where a place lies.
   *
   * @param place on the earth
   * @return the point, or none where it is too far away
   */
  public Optional<Point> point(GeoPoint place) {
    double[] o = Earth.centred(origin);
    double[] p = Earth.centred(place);
    double dx = p[0] - o[0];
    double dy = p[1] - o[1];
    double dz = p[2] - o[2];
    if (dx * dx + dy * dy + dz * dz > REACH * REACH) {
      return Optional.empty();
    }
    double sinLat = Math.sin(origin.latitude());
    double cosLat = Math.cos(origin.latitude());
    double sinLon = Math.sin(origin.longitude());
    double cosLon = Math.cos(origin.longitude());
    double outward = cosLon * dx + sinLon * dy;
    return Optional.of(new Point(cosLon * dy - sinLon * dx, cosLat * dz - sinLat * outward));
  }

  /**
   * What place lies at a point.
   *
   * @param east metres
   * @param north metres
   * @return the place, or none where the point is out of reach
   */
  public Optional<GeoPoint> place(double east, double north) {
    double distance2 = east * east + north * north;
    if (!(distance2 <= REACH * REACH)) {
      return Optional.empty();
    }
    // The earth falls away from the plane, and the point below one of the plane is not the one beneath it: found in
    // rounds.
    double aimEast = east;
    double aimNorth = north;
    double up = -distance2 / (2 * Earth.MEAN);
    GeoPoint found = below(aimEast, aimNorth, up);
    for (int i = 0; i < ROUNDS; i++) {
      Point reached = point(found).orElse(new Point(aimEast, aimNorth));
      aimEast += east - reached.east();
      aimNorth += north - reached.north();
      up = up(Earth.centred(found));
      found = below(aimEast, aimNorth, up);
    }
    return Optional.of(found);
  }

  private double up(double[] surface) {
    double[] o = Earth.centred(origin);
    double cosLat = Math.cos(origin.latitude());
    return cosLat * Math.cos(origin.longitude()) * (surface[0] - o[0])
        + cosLat * Math.sin(origin.longitude()) * (surface[1] - o[1])
        + Math.sin(origin.latitude()) * (surface[2] - o[2]);
  }

  private GeoPoint below(double east, double north, double up) {
    double[] o = Earth.centred(origin);
    double sinLat = Math.sin(origin.latitude());
    double cosLat = Math.cos(origin.latitude());
    double sinLon = Math.sin(origin.longitude());
    double cosLon = Math.cos(origin.longitude());
    double outward = cosLat * up - sinLat * north;
    return Earth.below(o[0] + cosLon * outward - sinLon * east, o[1] + sinLon * outward + cosLon * east,
        o[2] + cosLat * north + sinLat * up);
  }
}
