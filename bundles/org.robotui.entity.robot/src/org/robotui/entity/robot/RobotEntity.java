package org.robotui.entity.robot;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.Color;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Face;
import org.robotui.ui.Palette;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Painter;

/** The body of a robot: its outline or a circle, where it looks, and its name where there are several. */
public final class RobotEntity implements Entity {
  private static final double SMALLEST_PIXELS = 9;
  private static final double RIM = 1.5;
  private static final double FILL = 0.82;
  private static final double NAME_GAP = 6;
  private static final double RING = 2.5;
  private static final double RING_GAP = 4;

  private final int trace;
  private volatile Optional<Body> body = Optional.empty();
  private volatile boolean named;
  private volatile boolean selected;

  /**
   * Without a place.
   *
   * @param trace which colour of the theme's traces, from 0; taken modulo their number
   */
  public RobotEntity(int trace) {
    this.trace = trace;
  }

  /**
   * Takes where it is. Worker thread.
   *
   * @param newest the body in the fixed frame
   */
  public void prepare(Body newest) {
    body = Optional.of(newest);
  }

  /** Forgets where it is. Any thread. */
  public void clear() {
    body = Optional.empty();
  }

  /**
   * Whether the name is painted. Any thread.
   *
   * @param shown false at the beginning
   */
  public void showName(boolean shown) {
    named = shown;
  }

  /**
   * Whether it is marked as one that the user means. Any thread.
   *
   * @param meant false at the beginning
   */
  public void select(boolean meant) {
    selected = meant;
  }

  @Override
  public void paint(Painter painter) {
    body.ifPresent(b -> paint(painter, b));
  }

  @Override
  public Optional<Bounds> bounds() {
    return body.map(b -> Bounds.around(at(b).x(), at(b).y(), b.radius()));
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return body.flatMap(b -> {
      double distance = Math.max(0, Math.hypot(at(b).x() - x, at(b).y() - y) - b.radius());
      return distance > tolerance
          ? Optional.empty()
          : Optional.of(new Description(b.name() + "\n" + b.word(), distance));
    });
  }

  private void paint(Painter painter, Body b) {
    double pixels = Math.max(SMALLEST_PIXELS, b.radius() * painter.viewport().scale());
    painter.opacity(1).fill(fill(painter.theme())).stroke(rim(painter.theme())).width(RIM);
    boolean outlined = b.outline().isPresent() && b.radius() * painter.viewport().scale() >= SMALLEST_PIXELS;
    if (outlined) {
      paintOutline(painter, b.outline().get());
    } else {
      painter.disc(at(b).x(), at(b).y(), pixels);
      painter.circle(at(b).x(), at(b).y(), pixels);
    }
    paintHeading(painter, b, pixels);
    if (selected) {
      painter.opacity(1).stroke(Role.ACCENT).width(RING).circle(at(b).x(), at(b).y(), pixels + RING_GAP);
    }
    if (named) {
      painter.stroke(Role.TEXT).text(b.name(), at(b).x(), at(b).y(), pixels + NAME_GAP, 0, Face.SMALL);
    }
  }

  private static void paintOutline(Painter painter, List<Vector3> corners) {
    double[] xy = new double[2 * corners.size()];
    for (int i = 0; i < corners.size(); i++) {
      xy[2 * i] = corners.get(i).x();
      xy[2 * i + 1] = corners.get(i).y();
    }
    painter.area(xy, corners.size());
    painter.outline(xy, corners.size());
  }

  private static void paintHeading(Painter painter, Body b, double pixels) {
    double unit = pixels / painter.viewport().scale();
    double yaw = b.fixedFromBase().rotation().yaw();
    double[] triangle = new double[6];
    corner(triangle, 0, at(b), yaw, 0.88 * unit, 0);
    corner(triangle, 1, at(b), yaw, 0.28 * unit, 0.42 * unit);
    corner(triangle, 2, at(b), yaw, 0.28 * unit, -0.42 * unit);
    painter.fill(new Color(255, 255, 255)).area(triangle, 3);
  }

  private static void corner(double[] xy, int index, Vector3 at, double yaw, double ahead, double left) {
    xy[2 * index] = at.x() + ahead * Math.cos(yaw) - left * Math.sin(yaw);
    xy[2 * index + 1] = at.y() + ahead * Math.sin(yaw) + left * Math.cos(yaw);
  }

  private Color fill(Theme theme) {
    Color own = theme.traces().get(trace % theme.traces().size());
    return new Color(Palette.mix(own.getRGB(), theme.palette().rgb(Role.GROUND), theme.dark() ? FILL : 1));
  }

  private Color rim(Theme theme) {
    Color own = theme.traces().get(trace % theme.traces().size());
    return new Color(Palette.mix(theme.palette().rgb(theme.dark() ? Role.TEXT : Role.PANEL), own.getRGB(), FILL));
  }

  private static Vector3 at(Body b) {
    return b.fixedFromBase().translation();
  }
}
