package org.robotui.entity.odometry.internal.layer;

import java.util.Arrays;
import java.util.Optional;
import org.eclipse.swt.graphics.Color;
import org.robotui.entity.odometry.internal.colored.ColoredTrail;
import org.robotui.entity.odometry.internal.colored.WayPoints;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.ColorScale;
import org.robotui.ui.ColorBar;
import org.robotui.ui.Figures;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Painter;

/** A way whose colours tell a value. */
final class ColoredWayEntity implements Entity {
  private static final double WIDTH = 4;
  private static final int STEPS = 64;
  private static final int GREY = 0x808080;
  private static final int BYTE = 0xff;
  private static final int DECIMALS = 3;

  private volatile Optional<Prepared> prepared = Optional.empty();

  /** Places in the fixed frame, x and y in turn; a colour for the piece that leads to each. */
  private record Prepared(double[] xy, int[] rgb, double[] values, Bounds bounds, Optional<ColorScale> scale) {}

  /** Worker thread. */
  void prepare(ColoredTrail.Seen seen, RigidTransform fixedFromFrame) {
    WayPoints way = seen.way();
    double[] xy = new double[2 * way.count()];
    int[] rgb = new int[way.count()];
    for (int i = 0; i < way.count(); i++) {
      Vector3 at = fixedFromFrame
          .apply(new Vector3(way.xyz()[3 * i], way.xyz()[3 * i + 1], way.xyz()[3 * i + 2]));
      xy[2 * i] = at.x();
      xy[2 * i + 1] = at.y();
      double value = way.values()[i];
      rgb[i] = seen.scale().map(scale -> scale.rgb(stepped(scale, value))).orElse(GREY);
    }
    prepared = way.count() == 0 ? Optional.empty()
        : Optional.of(new Prepared(xy, rgb, way.values(), Bounds.of(xy), seen.scale()));
  }

  /** One of some values, so that pieces of about the same colour are one line. */
  private static double stepped(ColorScale scale, double value) {
    double step = (scale.high() - scale.low()) / STEPS;
    return step > 0 && Double.isFinite(step) && Double.isFinite(value)
        ? scale.low() + Math.rint((value - scale.low()) / step) * step
        : value;
  }

  void clear() {
    prepared = Optional.empty();
  }

  /** What the colours mean. */
  Optional<ColorBar> colors() {
    return prepared.flatMap(Prepared::scale)
        .map(s -> new ColorBar(s.title(), s.unit(), s.low(), s.high(), s::shade));
  }

  @Override
  public void paint(Painter painter) {
    prepared.ifPresent(way -> {
      painter.opacity(1).width(WIDTH);
      int count = way.rgb.length;
      int from = 0;
      while (from < count - 1) {
        int to = from + 1;
        while (to < count - 1 && way.rgb[to + 1] == way.rgb[from + 1]) {
          to++;
        }
        int rgb = way.rgb[from + 1];
        painter.stroke(new Color(rgb >> 16 & BYTE, rgb >> 8 & BYTE, rgb & BYTE));
        painter.polyline(Arrays.copyOfRange(way.xy, 2 * from, 2 * to + 2), to - from + 1);
        from = to;
      }
    });
  }

  @Override
  public Optional<Bounds> bounds() {
    return prepared.map(Prepared::bounds);
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return prepared.flatMap(way -> {
      int nearest = 0;
      for (int i = 1; i < way.rgb.length; i++) {
        nearest = distance(way, i, x, y) < distance(way, nearest, x, y) ? i : nearest;
      }
      double distance = distance(way, nearest, x, y);
      return distance > tolerance ? Optional.empty() : Optional.of(new Description(words(way, nearest), distance));
    });
  }

  private static double distance(Prepared way, int index, double x, double y) {
    return Math.hypot(way.xy[2 * index] - x, way.xy[2 * index + 1] - y);
  }

  private static String words(Prepared way, int index) {
    String title = way.scale.map(ColorScale::title).orElse("");
    double value = way.values[index];
    return "way\n" + (Double.isNaN(value) ? "no value there"
        : (title + "  " + Figures.of(value, DECIMALS, way.scale.map(ColorScale::unit).orElse(""))).strip());
  }
}
