package org.robotui.workbench.internal.pane;

import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.model.PortRow;

/** The ports of the selected robot: dot, name, rate and age. Display thread only. */
public final class PortList extends RowList<PortRow> {
  private static final int ROW = 24;
  private static final int TEXT_LEFT = 32;

  /** Makes an empty list. */
  public PortList(Composite parent, Theme theme) {
    super(parent, theme, ROW);
  }

  @Override
  protected String spoken(PortRow row) {
    return row.name() + ", " + row.figure();
  }

  @Override
  protected String hint(PortRow row) {
    return row.hint();
  }

  @Override
  protected void paintRow(GC gc, PortRow row, int top, int width) {
    HealthDot.paint(gc, theme(), row.health(), 19, top + ROW / 2, 7);
    gc.setFont(theme().font(Face.SMALL_FIGURES));
    gc.setForeground(theme().color(Role.DIM));
    Point size = gc.textExtent(row.figure());
    int left = Math.max(TEXT_LEFT, width - size.x - Theme.EDGE);
    gc.drawText(row.figure(), left, top + (ROW - size.y) / 2, true);
    gc.setFont(theme().font(Face.BODY));
    gc.setForeground(theme().color(row.health() == Health.NONE ? Role.DIM : Role.TEXT));
    String name = Shortened.to(gc, row.name(), left - TEXT_LEFT - Theme.STEP);
    gc.drawText(name, TEXT_LEFT, top + (ROW - gc.textExtent(name).y) / 2, true);
  }
}
