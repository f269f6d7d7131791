package org.robotui.entity.robot;

import java.util.Optional;
import org.eclipse.swt.graphics.Color;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.PoseEstimate;
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

/** An estimate of a pose: an arrow, and the ellipse of two standard deviations. */
public final class PoseEntity implements Entity {
  private static final double SIGMAS = 2;
  private static final double ARROW_PIXELS = 40;
  private static final double HEAD = 0.2;
  private static final int XY = 1;
  private static final int YY = 7;
  private static final int YAW_YAW = 35;

  private record Prepared(RigidTransform pose, Optional<double[]> ellipse, String text) {}

  private volatile Optional<Prepared> prepared = Optional.empty();
  private volatile Ink ink = Ink.USUAL;

  /** Without an estimate. */
  public PoseEntity() {
    // The first estimate comes with prepare.
  }

  /**
   * Takes an estimate in place of the one before. Worker thread.
   *
   * @param estimate the estimate
   * @param fixedFromFrame fixed frame from the frame of the estimate
   */
  public void prepare(PoseEstimate estimate, RigidTransform fixedFromFrame) {
    RigidTransform pose = fixedFromFrame.times(estimate.pose());
    Optional<double[]> ellipse = ellipse(estimate.covariance(), fixedFromFrame.rotation().yaw())
        .map(e -> e.outline(pose.translation().x(), pose.translation().y()));
    prepared = Optional.of(new Prepared(pose, ellipse, text(estimate)));
  }

  /**
   * The colour. Any thread.
   *
   * @param chosen that of warnings at the beginning
   */
  public void ink(Ink chosen) {
    ink = chosen;
  }

  @Override
  public void paint(Painter painter) {
    prepared.ifPresent(p -> {
      Color color = ink.of(painter.theme(), Role.WARNING);
      painter.fill(color).stroke(color);
      p.ellipse().ifPresent(xy -> {
        painter.opacity(0.14).area(xy, xy.length / 2);
        painter.opacity(0.7).width(1).outline(xy, xy.length / 2);
      });
      painter.opacity(1).width(2);
      arrow(painter, p.pose());
    });
  }

  @Override
  public Optional<Bounds> bounds() {
    return prepared.map(p -> Bounds.around(p.pose().translation().x(), p.pose().translation().y(), 0));
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return prepared.flatMap(p -> {
      double distance = Math.hypot(p.pose().translation().x() - x, p.pose().translation().y() - y);
      return distance > tolerance ? Optional.empty() : Optional.of(new Description(p.text(), distance));
    });
  }

  private static void arrow(Painter painter, RigidTransform pose) {
    double length = ARROW_PIXELS / painter.viewport().scale();
    Vector3 tip = pose.apply(new Vector3(length, 0, 0));
    Vector3 left = pose.apply(new Vector3(length * (1 - HEAD), length * HEAD * 0.8, 0));
    Vector3 right = pose.apply(new Vector3(length * (1 - HEAD), -length * HEAD * 0.8, 0));
    painter.line(pose.translation().x(), pose.translation().y(), tip.x(), tip.y());
    painter.polyline(new double[]{left.x(), left.y(), tip.x(), tip.y(), right.x(), right.y()}, 3);
    painter.disc(pose.translation().x(), pose.translation().y(), 2.5);
  }

  private static Optional<Ellipse> ellipse(Doubles c, double yaw) {
    return c.size() == 0
        ? Optional.empty()
        : Ellipse.ofCovariance(c.get(0), c.get(XY), c.get(YY), SIGMAS).map(e -> e.turned(yaw));
  }

  private static String text(PoseEstimate estimate) {
    Vector3 at = estimate.pose().translation();
    String place = "estimated pose  x " + Figures.fixed(at.x(), 2) + "  y " + Figures.of(at.y(), 2, "m")
        + "  " + Figures.degrees(estimate.pose().rotation().yaw(), 1);
    Doubles c = estimate.covariance();
    if (c.size() == 0) {
      return place;
    }
    double sigma = Math.sqrt(Math.max(0, Math.max(c.get(0), c.get(YY))));
    return place + "\n\u03c3 " + Figures.of(sigma, 2, "m") + ", "
        + Figures.degrees(Math.sqrt(Math.max(0, c.get(YAW_YAW))), 1);
  }
}
