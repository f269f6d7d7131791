package org.robotui.entity.path;

import java.util.Optional;
import org.eclipse.swt.graphics.Color;
import org.robotui.data.navigation.Path;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Painter;

/** A planned way: a line, and at its end the goal as a ring with what is left to go. */
public final class PathEntity implements Entity {
  private static final double WIDTH = 2;
  private static final double RING = 9;
  private static final double CORE = 3;
  private static final double LABEL_GAP = 15;

  private record Prepared(Line line, String label) {}

  private volatile Optional<Prepared> prepared = Optional.empty();
  private volatile Ink ink = Ink.USUAL;
  private volatile boolean labelled = true;

  /** Without a way. */
  public PathEntity() {
    // The first way comes with prepare.
  }

  /**
   * Takes a way in place of the one before. Worker thread.
   *
   * @param path the way; one without poses clears
   * @param fixedFromFrame fixed frame from the frame of the path
   * @param robot where the robot is in the fixed frame, to say what is left to go
   * @param speed how fast it goes, metres per second, to say how long it takes; 0 where it stands or that is not known
   */
  public void prepare(Path path, RigidTransform fixedFromFrame, Optional<Vector3> robot, double speed) {
    prepared = Line.of(path, fixedFromFrame).map(line -> new Prepared(line, label(line, robot, speed)));
  }

  /**
   * The colour. Any thread.
   *
   * @param chosen that of plans at the beginning
   */
  public void ink(Ink chosen) {
    ink = chosen;
  }

  /**
   * Whether what is left to go stands beside the goal, or is only told on asking. Any thread.
   *
   * @param shown true at the beginning
   */
  public void showLabel(boolean shown) {
    labelled = shown;
  }

  @Override
  public void paint(Painter painter) {
    prepared.ifPresent(p -> paint(painter, p, ink, labelled));
  }

  @Override
  public Optional<Bounds> bounds() {
    return prepared.map(p -> p.line().bounds());
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return prepared
        .filter(p -> p.line().distance(x, y) <= tolerance)
        .map(p -> new Description(
            "plan, " + Figures.of(p.line().length(), 1, "m") + " in all\n" + p.label(), p.line().distance(x, y)));
  }

  private static void paint(Painter painter, Prepared p, Ink own, boolean labelled) {
    Line line = p.line();
    Color color = own.of(painter.theme(), Role.PLAN);
    painter.opacity(1).stroke(color).fill(color).width(WIDTH).polyline(line.xy(), line.count());
    painter.circle(line.endX(), line.endY(), RING);
    painter.disc(line.endX(), line.endY(), CORE);
    if (labelled) {
      painter.label(p.label(), line.endX(), line.endY(), LABEL_GAP, 0, Face.BODY);
    }
  }

  private static String label(Line line, Optional<Vector3> robot, double speed) {
    double left = robot.map(r -> line.lengthFrom(r.x(), r.y())).orElse(line.length());
    String text = "goal  " + Figures.of(left, 1, "m");
    return speed > 0 ? text + "  \u00b7  " + Figures.of(Math.ceil(left / speed), 0, "s") : text;
  }
}
