package org.robotui.entity.laserscan;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.eclipse.swt.graphics.Color;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Painter;

/** The newest scan: a dot per echo and, faintly, the space that the beams crossed. */
public final class LaserScanEntity implements Entity {
  private static final double DOT = 4;
  private static final double FAINT = 0.11;

  private volatile Optional<ScanShape> shape = Optional.empty();
  private volatile boolean fan = true;
  private volatile OptionalInt trace = OptionalInt.empty();

  /** Without a scan. */
  public LaserScanEntity() {
    // The first scan comes with prepare.
  }

  /**
   * Takes a scan in place of the one before. Worker thread.
   *
   * @param scan the scan
   * @param fixedFromScanner fixed frame from the frame of the scanner, at the time of the scan
   */
  public void prepare(LaserScan scan, RigidTransform fixedFromScanner) {
    shape = Optional.of(ScanShape.of(scan, fixedFromScanner));
  }

  /** Forgets the scan. Any thread. */
  public void clear() {
    shape = Optional.empty();
  }

  /**
   * Whether the space that the beams crossed is painted. Any thread.
   *
   * @param shown true at the beginning
   */
  public void showFan(boolean shown) {
    fan = shown;
  }

  /**
   * Paints echoes and space in a colour of their own, to tell scans of several robots from one another. Any thread.
   *
   * @param of which colour of the theme's traces, from 0, taken modulo their number; none for that of lasers
   */
  public void tint(OptionalInt of) {
    trace = of;
  }

  @Override
  public void paint(Painter painter) {
    shape.ifPresent(s -> paint(painter, s));
  }

  @Override
  public Optional<Bounds> bounds() {
    return shape.flatMap(ScanShape::bounds);
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return shape.flatMap(s -> describe(s, x, y, tolerance));
  }

  private void paint(Painter painter, ScanShape s) {
    OptionalInt own = trace;
    if (fan) {
      fill(painter.opacity(FAINT), own, Role.ACCENT).area(s.fan(), s.fan().length / 2);
    }
    fill(painter.opacity(1), own, Role.LASER).points(s.echoes(), s.echoCount(), DOT);
  }

  private static Painter fill(Painter painter, OptionalInt own, Role usual) {
    List<Color> traces = painter.theme().traces();
    return own.isEmpty() ? painter.fill(usual) : painter.fill(traces.get(own.getAsInt() % traces.size()));
  }

  private static Optional<Description> describe(ScanShape s, double x, double y, double tolerance) {
    int nearest = -1;
    double best = tolerance;
    for (int i = 0; i < s.echoCount(); i++) {
      double distance = Math.hypot(s.echoes()[2 * i] - x, s.echoes()[2 * i + 1] - y);
      if (distance <= best) {
        best = distance;
        nearest = i;
      }
    }
    return nearest < 0 ? Optional.empty() : Optional.of(new Description(echo(s, nearest), best));
  }

  private static String echo(ScanShape s, int index) {
    int beam = s.beams()[index];
    return "echo " + Figures.of(s.scan().ranges().get(beam), 2, "m")
        + " at " + Figures.degrees(s.scan().angle(beam), 1)
        + "\nx " + Figures.fixed(s.echoes()[2 * index], 2) + "  y " + Figures.of(s.echoes()[2 * index + 1], 2, "m")
        + ", beam " + beam;
  }
}
