package org.robotui.entity.laserscan;

import java.util.Optional;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Painter;

/** The newest scan: a dot per echo and, faintly, the space that the beams crossed. */
public final class LaserScanEntity implements Entity {
  private static final double FAINT = 0.11;

  private volatile Optional<ScanShape> shape = Optional.empty();
  private volatile boolean fan = true;
  private volatile Ink ink = Ink.USUAL;
  private volatile double dot = 4;

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
   * The colour of echoes and space. Any thread.
   *
   * @param chosen that of lasers at the beginning
   */
  public void ink(Ink chosen) {
    ink = chosen;
  }

  /**
   * The edge of an echo. Any thread.
   *
   * @param pixels 4 at the beginning
   */
  public void size(double pixels) {
    dot = pixels;
  }

  /**
   * How many echoes the newest scan has. Any thread.
   *
   * @return 0 without a scan
   */
  public int echoes() {
    return shape.map(ScanShape::echoCount).orElse(0);
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
    Ink own = ink;
    if (fan) {
      painter.opacity(FAINT).fill(own.of(painter.theme(), Role.ACCENT)).area(s.fan(), s.fan().length / 2);
    }
    painter.opacity(1).fill(own.of(painter.theme(), Role.LASER)).points(s.echoes(), s.echoCount(), dot);
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
