package org.robotui.uic.map.internal.view;

import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Painter;

/** Measures distance and direction between two points; the measure stays until the next one. */
final class MeasureTool implements Tool {
  private static final double LABEL_GAP = 12;
  private static final double DOT = 3;

  private double fromX;
  private double fromY;
  private double toX;
  private double toY;
  private boolean measured;

  @Override
  public String id() {
    return "measure";
  }

  @Override
  public String hint() {
    return "Measure: drag from point to point \u00b7 Esc ends";
  }

  @Override
  public void down(double x, double y) {
    fromX = x;
    fromY = y;
    drag(x, y);
  }

  @Override
  public void drag(double x, double y) {
    toX = x;
    toY = y;
    measured = true;
  }

  @Override
  public void up(double x, double y) {
    drag(x, y);
  }

  @Override
  public void paint(Painter painter) {
    if (measured) {
      painter.opacity(1).stroke(Role.TEXT).fill(Role.TEXT).dashed(1.5, 5).line(fromX, fromY, toX, toY);
      painter.width(1.5).disc(fromX, fromY, DOT);
      painter.disc(toX, toY, DOT);
      painter.label(label(), toX, toY, LABEL_GAP, -LABEL_GAP, Face.FIGURES);
    }
  }

  String label() {
    double dx = toX - fromX;
    double dy = toY - fromY;
    return Figures.of(Math.hypot(dx, dy), 2, "m") + "  " + Figures.degrees(Math.atan2(dy, dx), 1);
  }
}
