package org.robotui.workbench.internal.pane;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Face;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.model.RobotRow;

/** The robots: two lines each. A press or Enter selects, the arrow keys move. Display thread only. */
public final class RobotList extends RowList<RobotRow> {
  private static final int ROW = 48;
  private static final int TEXT_LEFT = 32;

  private String selected = "";

  /**
   * Makes an empty list.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param select is given the name of the robot that the user selects
   */
  public RobotList(Composite parent, Theme theme, Consumer<String> select) {
    super(parent, theme, ROW);
    addListener(SWT.MouseDown, e -> press(e, select));
    addListener(SWT.KeyDown, e -> key(e, select));
  }

  /** Shows robots, of which one is selected; empty for none. */
  public void show(List<RobotRow> rows, String selectedName) {
    boolean moved = !selected.equals(selectedName);
    selected = selectedName;
    show(rows);
    if (moved) {
      redraw();
    }
  }

  private void press(Event event, Consumer<String> select) {
    setFocus();
    Optional<RobotRow> row = at(event.y);
    row.ifPresent(r -> point(rows().indexOf(r)));
    if (event.button == 1) {
      row.map(RobotRow::name).ifPresent(select);
    }
  }

  private void key(Event event, Consumer<String> select) {
    if (event.character == SWT.CR || event.character == ' ') {
      pointed().map(RobotRow::name).ifPresent(select);
    }
  }

  @Override
  protected String spoken(RobotRow row) {
    return row.name() + ", " + row.figure() + ", " + row.second();
  }

  @Override
  protected String hint(RobotRow row) {
    return row.name() + "\n" + row.figure() + "\n" + row.second();
  }

  @Override
  protected void paintRow(GC gc, RobotRow row, int top, int width) {
    boolean chosen = row.name().equals(selected);
    if (chosen) {
      gc.setBackground(theme().mix(Role.ACCENT, Role.PANEL, 0.14));
      gc.fillRectangle(0, top, width, ROW);
      gc.setBackground(theme().color(Role.ACCENT));
      gc.fillRectangle(0, top, 3, ROW);
    }
    HealthDot.paint(gc, theme(), row.health(), 19, top + 16);
    Face face = chosen ? Face.TITLE : Face.NAME;
    int room = width - TEXT_LEFT - Theme.STEP - Theme.EDGE - width(gc, Face.SMALL, row.figure());
    // Whose row it is matters more than the figure, which the tooltip tells.
    int figure = width(gc, face, row.name()) <= room ? paintFigure(gc, row, top, width) : width;
    gc.setFont(theme().font(face));
    gc.setForeground(theme().color(Role.TEXT));
    gc.drawText(TextFit.shorten(gc, row.name(), figure - TEXT_LEFT - Theme.STEP), TEXT_LEFT, top + 7, true);
    gc.setFont(theme().font(Face.SMALL));
    gc.setForeground(theme().color(Role.DIM));
    gc.drawText(TextFit.shorten(gc, row.second(), width - TEXT_LEFT - Theme.EDGE), TEXT_LEFT, top + 27, true);
  }

  private int paintFigure(GC gc, RobotRow row, int top, int width) {
    gc.setFont(theme().font(Face.SMALL));
    gc.setForeground(theme().color(Role.DIM));
    Point size = gc.textExtent(row.figure());
    int left = width - size.x - Theme.EDGE;
    gc.drawText(row.figure(), left, top + 9, true);
    return left;
  }
}
