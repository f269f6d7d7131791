package org.robotui.entity.odometry;

import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Ellipse;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Painter;

/**
 * The way that a robot has gone by its odometry, and optionally the ellipse of two standard deviations around its
 * place. The way is kept in the frame of the odometry: when localisation moves that frame, the whole way moves with it.
 */
public final class OdometryEntity implements Entity {
  private static final int CAPACITY = 4000;
  private static final double SIGMAS = 2;
  private static final double WIDTH = 2;
  private static final double OPACITY = 0.75;
  private static final int XY = 1;
  private static final int YY = 7;

  private record Prepared(double[] way, Bounds bounds, Optional<double[]> uncertainty, Odometry newest) {}

  private final Trail trail = new Trail(CAPACITY);
  private Optional<FrameId> frame = Optional.empty();
  private volatile Optional<Prepared> prepared = Optional.empty();
  private volatile boolean ellipse;
  private volatile Ink ink;

  /**
   * Without a way.
   *
   * @param trace which colour of the theme's traces, from 0; taken modulo their number
   */
  public OdometryEntity(int trace) {
    ink = new Ink.Trace(trace);
  }

  /**
   * Adds a position. Worker thread, one at a time.
   *
   * @param odometry the newest
   * @param fixedFromFrame fixed frame from the frame of the odometry
   * @param length of the way to keep, metres
   */
  public void prepare(Odometry odometry, RigidTransform fixedFromFrame, double length) {
    if (!frame.equals(Optional.of(odometry.frame()))) {
      trail.clear();
      frame = Optional.of(odometry.frame());
    }
    Vector3 at = odometry.pose().translation();
    trail.add(at.x(), at.y());
    trail.cut(length);
    Optional<double[]> uncertainty = uncertainty(odometry, fixedFromFrame);
    double[] way = way(fixedFromFrame, at);
    prepared = Optional.of(new Prepared(way, Bounds.of(way), uncertainty, odometry));
  }

  /** Forgets the way, for example when the clock has jumped back. Worker thread. */
  public void clear() {
    trail.clear();
    prepared = Optional.empty();
  }

  /**
   * The colour. Any thread.
   *
   * @param chosen a trace of the theme at the beginning
   */
  public void ink(Ink chosen) {
    ink = chosen;
  }

  /**
   * Whether the uncertainty is painted. Any thread.
   *
   * @param shown false at the beginning
   */
  public void showUncertainty(boolean shown) {
    ellipse = shown;
  }

  @Override
  public void paint(Painter painter) {
    prepared.ifPresent(p -> {
      painter.stroke(ink.of(painter.theme(), Role.ACCENT));
      painter.fill(painter.gc().getForeground());
      painter.opacity(OPACITY).width(WIDTH).polyline(p.way(), p.way().length / 2);
      if (ellipse) {
        p.uncertainty().ifPresent(xy -> paintEllipse(painter, xy));
      }
      painter.opacity(1);
    });
  }

  @Override
  public Optional<Bounds> bounds() {
    return prepared.map(Prepared::bounds);
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return prepared.flatMap(p -> {
      double distance = distance(p.way(), x, y);
      return distance > tolerance ? Optional.empty() : Optional.of(new Description(text(p.newest()), distance));
    });
  }

  private double[] way(RigidTransform fixedFromFrame, Vector3 newest) {
    double[] kept = trail.points();
    double[] way = new double[kept.length + 2];
    for (int i = 0; i < kept.length / 2; i++) {
      put(way, i, fixedFromFrame.apply(new Vector3(kept[2 * i], kept[2 * i + 1], 0)));
    }
    put(way, kept.length / 2, fixedFromFrame.apply(newest));
    return way;
  }

  private static void paintEllipse(Painter painter, double[] xy) {
    painter.opacity(0.12).area(xy, xy.length / 2);
    painter.opacity(0.6).width(1).outline(xy, xy.length / 2);
  }

  private static Optional<double[]> uncertainty(Odometry odometry, RigidTransform fixedFromFrame) {
    Doubles c = odometry.poseCovariance();
    if (c.size() == 0) {
      return Optional.empty();
    }
    Vector3 at = fixedFromFrame.apply(odometry.pose().translation());
    double yaw = fixedFromFrame.rotation().yaw();
    return Ellipse.ofCovariance(c.get(0), c.get(XY), c.get(YY), SIGMAS).map(e -> e.turned(yaw).outline(at.x(), at.y()));
  }

  private static String text(Odometry o) {
    return "odometry  x " + Figures.fixed(o.pose().translation().x(), 2)
        + "  y " + Figures.of(o.pose().translation().y(), 2, "m")
        + "  " + Figures.degrees(o.pose().rotation().yaw(), 1)
        + "\n" + Figures.of(o.linear().x(), 2, "m/s") + ", "
        + Figures.of(Math.toDegrees(o.angular().z()), 1, "\u00b0/s");
  }

  private static double distance(double[] way, double x, double y) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < way.length / 2; i++) {
      nearest = Math.min(nearest, Math.hypot(way[2 * i] - x, way[2 * i + 1] - y));
    }
    return nearest;
  }

  private static void put(double[] xy, int index, Vector3 point) {
    xy[2 * index] = point.x();
    xy[2 * index + 1] = point.y();
  }
}
