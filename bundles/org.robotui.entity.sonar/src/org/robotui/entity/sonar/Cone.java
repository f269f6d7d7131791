package org.robotui.entity.sonar;

import java.util.Optional;
import org.robotui.data.sensor.RangeReading;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Bounds;

/**
 * A reading in the fixed frame.
 *
 * @param reading the reading
 * @param echo whether something was hit; else the cone reaches to the limit of the sensor
 * @param corners x and y of its outline in turn: the sensor, then the arc
 * @param arc x and y of the arc in turn
 */
record Cone(RangeReading reading, boolean echo, double[] corners, double[] arc) {
  private static final double STEP = Math.toRadians(3);
  private static final double NARROWEST = Math.toRadians(0.5);

  /** None where the measurement says nothing: invalid, or too close to measure. */
  static Optional<Cone> of(SonarEntity.Placed placed) {
    RangeReading reading = placed.reading();
    boolean echo = reading.isEcho();
    if (!echo && !(reading.range() > reading.rangeMax())) {
      return Optional.empty();
    }
    double[] arc = arc(reading, placed.fixedFromSensor(), echo ? reading.range() : reading.rangeMax());
    double[] corners = new double[arc.length + 2];
    corners[0] = placed.fixedFromSensor().translation().x();
    corners[1] = placed.fixedFromSensor().translation().y();
    System.arraycopy(arc, 0, corners, 2, arc.length);
    return Optional.of(new Cone(reading, echo, corners, arc));
  }

  Bounds bounds() {
    return Bounds.of(corners);
  }

  double distanceToArc(double x, double y) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < arc.length / 2; i++) {
      nearest = Math.min(nearest, Math.hypot(arc[2 * i] - x, arc[2 * i + 1] - y));
    }
    return nearest;
  }

  private static double[] arc(RangeReading reading, RigidTransform fixedFromSensor, double range) {
    double opening = Math.clamp(reading.fieldOfView(), NARROWEST, 2 * Math.PI);
    // An even number, so that one corner lies straight ahead.
    int steps = 2 * (int) Math.ceil(opening / 2 / STEP);
    double[] xy = new double[2 * (steps + 1)];
    for (int i = 0; i <= steps; i++) {
      double angle = opening * (i / (double) steps - 0.5);
      Vector3 end = fixedFromSensor.apply(new Vector3(range * Math.cos(angle), range * Math.sin(angle), 0));
      xy[2 * i] = end.x();
      xy[2 * i + 1] = end.y();
    }
    return xy;
  }
}
