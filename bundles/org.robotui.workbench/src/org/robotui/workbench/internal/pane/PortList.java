package org.robotui.workbench.internal.pane;

import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.model.PortRow;

/** The ports of the selected robot: dot, name, rate and age. Display thread only. */
public final class PortList extends RowList<PortRow> {
  private static final int ROW = 24;
  private static final int TEXT_LEFT = 32;
  private static final String WIDEST_AGE = "999\u00a0ms";

  private int ageWidth;

  /** Makes an empty list. */
  public PortList(Composite parent, Theme theme) {
    super(parent, theme, ROW);
  }

  @Override
  protected String spoken(PortRow row) {
    return row.name() + ", " + row.figure() + (row.age().isEmpty() ? "" : ", " + row.age());
  }

  @Override
  protected String hint(PortRow row) {
    return row.hint();
  }

  /** Ages are shown where there is room for them beside all names; else the tooltip tells them. */
  @Override
  void prepare(GC gc, int width) {
    int age = width(gc, Face.SMALL_FIGURES, WIDEST_AGE);
    gc.setFont(theme().font(Face.BODY));
    int names = rows().stream().filter(row -> !row.age().isEmpty()).mapToInt(row -> gc.textExtent(row.name()).x).max()
        .orElse(0);
    gc.setFont(theme().font(Face.SMALL_FIGURES));
    int rates = rows().stream().filter(row -> !row.age().isEmpty()).mapToInt(row -> gc.textExtent(row.figure()).x).max()
        .orElse(0);
    ageWidth = TEXT_LEFT + names + rates + age + 3 * Theme.STEP + Theme.EDGE <= width ? age + Theme.STEP : 0;
  }

  @Override
  protected void paintRow(GC gc, PortRow row, int top, int width) {
    HealthDot.paint(gc, theme(), row.health(), 19, top + ROW / 2, 7);
    gc.setFont(theme().font(Face.SMALL_FIGURES));
    gc.setForeground(theme().color(Role.DIM));
    int right = width - Theme.EDGE;
    if (ageWidth > 0 && !row.age().isEmpty()) {
      right(gc, row.age(), right, top);
      right -= ageWidth;
    }
    int whole = width(gc, Face.BODY, row.name());
    gc.setFont(theme().font(Face.SMALL_FIGURES));
    boolean both = TEXT_LEFT + whole + Theme.STEP + gc.textExtent(row.figure()).x <= right;
    // A name without its middle says less than a name without its rate, which the tooltip tells.
    int left = both ? right(gc, row.figure(), right, top) : width - Theme.STEP;
    gc.setFont(theme().font(Face.BODY));
    gc.setForeground(theme().color(row.health() == Health.NONE ? Role.DIM : Role.TEXT));
    String name = TextFit.inTheMiddle(gc, row.name(), left - TEXT_LEFT - Theme.STEP);
    gc.drawText(name, TEXT_LEFT, top + (ROW - gc.textExtent(name).y) / 2, true);
  }

  private static int right(GC gc, String text, int right, int top) {
    Point size = gc.textExtent(text);
    int left = Math.max(TEXT_LEFT, right - size.x);
    gc.drawText(text, left, top + (ROW - size.y) / 2, true);
    return left;
  }
}
