package org.robotui.entity.bumper.internal;

import java.util.ArrayList;
import java.util.List;
import org.robotui.data.sensor.Bumper;
import org.robotui.geometry.Vector3;

/** The line along a bumper. */
public final class Rim {
  private static final double STEP = Math.toRadians(6);

  private Rim() {}

  /**
   * Points from its right end to its left one, with the middle as origin; none where its place is not known. A bend is
   * at most a full turn.
   */
  public static List<Vector3> of(Bumper bumper) {
    if (!(bumper.length() > 0)) {
      return List.of();
    }
    double half = bumper.length() / 2;
    if (!(bumper.radius() > 0)) {
      return List.of(new Vector3(0, -half, 0), new Vector3(0, half, 0));
    }
    double opening = Math.min(half / bumper.radius(), Math.PI);
    int steps = 2 * (int) Math.max(1, Math.ceil(opening / STEP));
    List<Vector3> points = new ArrayList<>(steps + 1);
    for (int i = 0; i <= steps; i++) {
      double angle = opening * (2.0 * i / steps - 1);
      points.add(new Vector3(bumper.radius() * (Math.cos(angle) - 1), bumper.radius() * Math.sin(angle), 0));
    }
    return points;
  }
}
