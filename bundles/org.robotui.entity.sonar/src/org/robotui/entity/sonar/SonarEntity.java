package org.robotui.entity.sonar;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.Color;
import org.robotui.data.sensor.RangeReading;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Painter;

/** Cones of sonars: free up to the echo, whose arc is drawn; without an echo the cone is only hinted at. */
public final class SonarEntity implements Entity {
  private static final double FREE = 0.14;
  private static final double HINT = 0.06;
  private static final double LINE = 1.8;
  /** More than any robot has. */
  private static final int MOST = 1000;

  private volatile List<Cone> cones = List.of();
  private volatile Ink ink = Ink.USUAL;

  /** Without readings. */
  public SonarEntity() {
    // The first readings come with prepare.
  }

  /**
   * A reading and where its sensor is.
   *
   * @param reading the reading
   * @param fixedFromSensor fixed frame from the frame of the sensor
   */
  public record Placed(RangeReading reading, RigidTransform fixedFromSensor) {}

  /**
   * Takes readings in place of those before. Worker thread.
   *
   * @param readings one per sensor
   */
  public void prepare(List<Placed> readings) {
    cones = readings.stream().limit(MOST).flatMap(p -> Cone.of(p).stream()).toList();
  }

  /**
   * The colour. Any thread.
   *
   * @param chosen that of sonars at the beginning
   */
  public void ink(Ink chosen) {
    ink = chosen;
  }

  @Override
  public void paint(Painter painter) {
    List<Cone> shown = cones;
    Color color = ink.of(painter.theme(), Role.SONAR);
    painter.fill(color).stroke(color).width(LINE);
    for (Cone cone : shown) {
      painter.opacity(cone.echo() ? FREE : HINT).area(cone.corners(), cone.corners().length / 2);
    }
    painter.opacity(1);
    for (Cone cone : shown) {
      if (cone.echo()) {
        painter.polyline(cone.arc(), cone.arc().length / 2);
      }
    }
  }

  @Override
  public Optional<Bounds> bounds() {
    return cones.stream().map(Cone::bounds).reduce(Bounds::union);
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return cones.stream()
        .filter(Cone::echo)
        .filter(cone -> cone.distanceToArc(x, y) <= tolerance)
        .findFirst()
        .map(cone -> new Description(text(cone.reading()), cone.distanceToArc(x, y)));
  }

  private static String text(RangeReading reading) {
    String kind = reading.kind() == RangeReading.Kind.INFRARED ? "infrared " : "sonar ";
    return kind + reading.frame().name() + ": " + Figures.of(reading.range(), 2, "m");
  }
}
