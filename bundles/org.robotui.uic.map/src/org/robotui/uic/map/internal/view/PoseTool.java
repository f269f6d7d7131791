package org.robotui.uic.map.internal.view;

import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.ToDoubleBiFunction;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Painter;

/** Points out a pose: press where, drag to where it looks, let go. */
final class PoseTool implements Tool {
  private static final double ARROW = 44;
  private static final double HEAD = 9;
  private static final double RING = 9;
  private static final double LEAST_DRAG = 8;

  private final String id;
  private final String hint;
  private final Role role;
  private final ToDoubleBiFunction<Double, Double> usualHeading;
  private final Consumer<RigidTransform> chosen;
  private double x;
  private double y;
  private double scale = 1;
  private boolean held;
  private OptionalDouble heading = OptionalDouble.empty();

  PoseTool(
      String id,
      String hint,
      Role role,
      ToDoubleBiFunction<Double, Double> usualHeading,
      Consumer<RigidTransform> chosen) {
    this.id = id;
    this.hint = hint;
    this.role = role;
    this.usualHeading = usualHeading;
    this.chosen = chosen;
  }

  @Override
  public String id() {
    return id;
  }

  @Override
  public String hint() {
    return hint;
  }

  @Override
  public void down(double worldX, double worldY) {
    x = worldX;
    y = worldY;
    held = true;
    heading = OptionalDouble.empty();
  }

  @Override
  public void drag(double worldX, double worldY) {
    boolean far = Math.hypot(worldX - x, worldY - y) * scale >= LEAST_DRAG;
    heading = far ? OptionalDouble.of(Math.atan2(worldY - y, worldX - x)) : OptionalDouble.empty();
  }

  @Override
  public void up(double worldX, double worldY) {
    if (held) {
      drag(worldX, worldY);
      held = false;
      chosen.accept(RigidTransform.planar(x, y, yaw()));
    }
  }

  @Override
  public void paint(Painter painter) {
    scale = painter.viewport().scale();
    if (held) {
      painter.opacity(1).stroke(role).fill(role).width(2);
      painter.circle(x, y, RING);
      Arrow.paint(painter, RigidTransform.planar(x, y, yaw()), ARROW, HEAD);
      painter.label(Figures.degrees(yaw(), 0), x, y, RING + 6, RING + 10, Face.FIGURES);
    }
  }

  private double yaw() {
    return heading.orElseGet(() -> usualHeading.applyAsDouble(x, y));
  }
}
