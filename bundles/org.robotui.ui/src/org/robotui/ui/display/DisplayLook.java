package org.robotui.ui.display;

import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.RowLook;

/** One in the list: box, dot, name, and in a second line why nothing is seen. */
final class DisplayLook implements RowLook<DisplayRow> {
  /** Where a press switches. */
  static final int BOX_END = 34;

  private static final int HEIGHT = 40;
  private static final int BOX = 15;
  private static final int CORNER = 5;
  private static final int NAME = 54;
  private static final double MEGA = 1e6;
  private static final double WORTH_SAYING = 5e4;

  private final Theme theme;

  DisplayLook(Theme theme) {
    this.theme = theme;
  }

  @Override
  public Object key(DisplayRow row) {
    return row.spec().id();
  }

  @Override
  public String text(DisplayRow row) {
    return row.name() + ": " + row.words();
  }

  @Override
  public String hint(GC gc, Rectangle at, DisplayRow row, int x) {
    return x < BOX_END ? row.spec().shown() ? "Hide" : "Show" : row.words() + sources(row);
  }

  private static String sources(DisplayRow row) {
    return row.spec().sources().isEmpty() ? "" : "\nfrom " + String.join(", ", row.spec().sources());
  }

  @Override
  public int height() {
    return HEIGHT;
  }

  @Override
  public void paint(GC gc, Rectangle at, DisplayRow row) {
    box(gc, at.x + Theme.EDGE, at.y + 5, row.spec().shown());
    HealthDot.paint(gc, theme, row.health(), at.x + Theme.EDGE + BOX + 3 * Theme.STEP, at.y + 13);
    gc.setFont(theme.font(Face.SMALL));
    String size = row.bytes() >= WORTH_SAYING ? Figures.of(row.bytes() / MEGA, 1, "MB") : "";
    int right = at.x + at.width - Theme.EDGE;
    int taken = size.isEmpty() ? 0 : gc.textExtent(size).x;
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(size, right - taken, at.y + 5, true);
    gc.drawText(TextFit.shorten(gc, row.words(), right - at.x - NAME), at.x + NAME, at.y + 21, true);
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(row.spec().shown() ? Role.TEXT : Role.DIM));
    gc.drawText(TextFit.shorten(gc, row.name(), right - at.x - NAME - taken - Theme.STEP), at.x + NAME, at.y + 4, true);
  }

  private void box(GC gc, int x, int y, boolean on) {
    gc.setBackground(theme.color(on ? Role.ACCENT : Role.GROUND));
    gc.fillRoundRectangle(x, y, BOX, BOX, CORNER, CORNER);
    gc.setForeground(theme.color(on ? Role.ACCENT : Role.DIM));
    gc.setLineWidth(1);
    gc.drawRoundRectangle(x, y, BOX, BOX, CORNER, CORNER);
    if (on) {
      gc.setForeground(theme.on(Role.ACCENT));
      Icons.paint(gc, Icon.CHECK, x + 2, y + 2, BOX - 4);
    }
  }
}
