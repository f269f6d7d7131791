package org.robotui.uic.map.internal.view;

import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Painter;

/**
 * Measures distance and direction between two points, given by two clicks or by one drag. The measure stays until the
 * next one.
 */
final class MeasureTool implements Tool {
  private static final double LABEL_GAP = 12;
  private static final double DOT = 3;
  /** As far as a hand moves that only clicks, pixels. */
  private static final double STILL = 4;

  private enum Step {
    /** Nothing is measured. */
    NOTHING,
    /** The button is held; whether that is a click or a drag is seen when it is let go. */
    FIRST_HELD,
    /** The first end was clicked; the second follows the pointer. */
    FIRST_SET,
    /** The second end is being clicked. */
    SECOND_HELD,
    /** Both ends are set. */
    DONE
  }

  private double fromX;
  private double fromY;
  private double toX;
  private double toY;
  private double scale = 1;
  private Step step = Step.NOTHING;

  @Override
  public String id() {
    return "measure";
  }

  @Override
  public String hint() {
    return step == Step.FIRST_SET ? "Measure: click the second point \u00b7 Esc ends"
        : "Measure: click two points, or drag from one to the other \u00b7 Esc ends";
  }

  @Override
  public void down(double x, double y) {
    if (step == Step.FIRST_SET) {
      step = Step.SECOND_HELD;
    } else {
      step = Step.FIRST_HELD;
      fromX = x;
      fromY = y;
    }
    drag(x, y);
  }

  @Override
  public void drag(double x, double y) {
    toX = x;
    toY = y;
  }

  @Override
  public void up(double x, double y) {
    drag(x, y);
    step = step == Step.FIRST_HELD && length() * scale < STILL ? Step.FIRST_SET : Step.DONE;
  }

  @Override
  public void hover(double x, double y) {
    if (step == Step.FIRST_SET) {
      drag(x, y);
    }
  }

  @Override
  public void paint(Painter painter) {
    scale = painter.viewport().scale();
    if (step == Step.NOTHING) {
      return;
    }
    painter.opacity(1).stroke(Role.TEXT).fill(Role.TEXT).dashed(1.5, 5).line(fromX, fromY, toX, toY);
    painter.width(1.5).disc(fromX, fromY, DOT);
    if (length() > 0) {
      painter.disc(toX, toY, DOT);
      painter.label(label(), toX, toY, LABEL_GAP, -LABEL_GAP, Face.FIGURES);
    }
  }

  String label() {
    return Figures.of(length(), 2, "m") + "  " + Figures.degrees(Math.atan2(toY - fromY, toX - fromX), 1);
  }

  private double length() {
    return Math.hypot(toX - fromX, toY - fromY);
  }
}
