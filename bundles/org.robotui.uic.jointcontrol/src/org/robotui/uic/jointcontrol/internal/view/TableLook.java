package org.robotui.uic.jointcontrol.internal.view;

import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.RowLook;
import org.robotui.ui.control.RowWords;
import org.robotui.uic.jointcontrol.internal.model.ChainHead;
import org.robotui.uic.jointcontrol.internal.model.Grid;
import org.robotui.uic.jointcontrol.internal.model.JointColumn;
import org.robotui.uic.jointcontrol.internal.model.JointLine;
import org.robotui.uic.jointcontrol.internal.model.JointRow;

/** How chains and joints look in the table. Display thread. */
final class TableLook implements RowLook<JointLine> {
  static final int PADDING = 2 * Theme.STEP;

  private static final int DOT = HealthDot.SIZE + 2 * Theme.STEP;
  private static final int FOLD = 12;
  private static final int LOAD = 3;
  private static final double HIGH_LOAD = 0.8;

  private final Theme theme;
  private final RowWords text;
  private final RangeBar range;
  private Grid grid = Grid.of(0, false, 0);
  private Set<String> measured = Set.of();
  private int names;
  private int width;
  private boolean driving;
  private boolean drivable;

  TableLook(Theme theme) {
    this.theme = theme;
    text = new RowWords(theme);
    range = new RangeBar(theme);
  }

  /** Where the columns stand in a width. */
  Grid grid(int room, boolean withTarget) {
    if (width != room || driving != withTarget) {
      width = room;
      driving = withTarget;
      grid = Grid.of(room, withTarget, names);
    }
    return grid;
  }

  /** Makes room for the names of all joints, also of those that are not listed now: columns stay where they are. */
  void names(Control in, Set<String> joints) {
    if (!measured.equals(joints)) {
      measured = Set.copyOf(joints);
      GC gc = new GC(in);
      gc.setFont(theme.font(Face.BODY));
      names = joints.stream().mapToInt(name -> gc.textExtent(name).x).max().orElse(0) + DOT + 2 * PADDING;
      gc.dispose();
      grid = Grid.of(width, driving, names);
    }
  }

  /** Whether joints have knobs to be dragged. */
  void drivable(boolean now) {
    drivable = now;
  }

  @Override
  public Object key(JointLine line) {
    return line.key();
  }

  @Override
  public String text(JointLine line) {
    return switch (line) {
      case ChainHead head -> head.title() + "\t" + head.words();
      case JointRow row -> Stream.of(JointColumn.values()).map(column -> column.text(row))
          .filter(words -> !words.isEmpty())
          .collect(Collectors.joining("\t"));
    };
  }

  @Override
  public String hint(GC gc, Rectangle at, JointLine line, int x) {
    return switch (line) {
      case ChainHead head -> head.words();
      // A tooltip would lie over the joints below while a hand drags; the figures stand in the row.
      case JointRow row -> grid(at.width, driving).at(x - at.x)
          .filter(column -> !(drivable && column == JointColumn.RANGE))
          .flatMap(column -> column.hint(row)).orElse("");
    };
  }

  @Override
  public void paint(GC gc, Rectangle at, JointLine line) {
    switch (line) {
      case ChainHead head -> head(gc, at, head);
      case JointRow row -> grid(at.width, driving).places().forEach(
          (column, place) -> cell(gc, new Rectangle(at.x + place.left(), at.y, place.width(), at.height), column, row));
    }
  }

  private void head(GC gc, Rectangle at, ChainHead head) {
    gc.setForeground(theme.color(Role.DIM));
    Icons.paint(gc, head.open() ? Icon.OPEN : Icon.CLOSED, at.x + PADDING, at.y + (at.height - FOLD) / 2, FOLD);
    int left = at.x + PADDING + FOLD + Theme.STEP;
    int title = text.cell(gc, new Rectangle(left, at.y, at.width - left, at.height), head.title(), Face.SMALL_STRONG,
        theme.color(Role.TEXT), false);
    int dot = left + title + Theme.EDGE;
    HealthDot.paint(gc, theme, head.health(), dot + HealthDot.SIZE / 2, at.y + at.height / 2);
    int words = dot + DOT;
    text.cell(gc, new Rectangle(words, at.y, Math.max(0, at.x + at.width - words - PADDING), at.height), head.words(),
        Face.SMALL,
        theme.color(Role.DIM), false);
  }

  private void cell(GC gc, Rectangle cell, JointColumn column, JointRow row) {
    Rectangle at = new Rectangle(cell.x + PADDING, cell.y, Math.max(0, cell.width - 2 * PADDING), cell.height);
    switch (column) {
      case RANGE -> range.paint(gc, cell, row, drivable);
      case NAME -> dotted(gc, at, row.health(), row.name(), theme.color(Role.TEXT));
      case SOURCE -> text.cell(gc, at, row.source(), Face.BODY, color(JointRow.health(row.state().source())), false);
      case FAULTS -> faults(gc, at, row);
      case EFFORT -> effort(gc, at, row);
      default -> text.cell(gc, at, column.text(row), column.isFigure() ? Face.FIGURES : Face.BODY, ink(column, row),
          column.isFigure());
    }
  }

  /** What is as it should be is quiet; the dot before the name tells it, too. */
  private Color color(Health health) {
    return theme.color(health == Health.OK || health == Health.NONE ? Role.DIM : health.role());
  }

  private Color ink(JointColumn column, JointRow row) {
    boolean quiet = switch (column) {
      case TEMPERATURE, MODE, GAINS, OWNER -> true;
      case COUNTS -> row.state().clamped() + row.state().rejected() == 0;
      default -> false;
    };
    return theme.color(column == JointColumn.TARGET ? Role.ACCENT : quiet ? Role.DIM : Role.TEXT);
  }

  private void dotted(GC gc, Rectangle at, Health health, String words, Color color) {
    HealthDot.paint(gc, theme, health, at.x + HealthDot.SIZE / 2, at.y + at.height / 2);
    text.cell(gc, new Rectangle(at.x + DOT, at.y, Math.max(0, at.width - DOT), at.height), words, Face.BODY, color,
        false);
  }

  private void faults(GC gc, Rectangle at, JointRow row) {
    boolean well = row.state().faults() == 0;
    text.cell(gc, at, row.faults(), Face.FIGURES, theme.color(well ? Role.DIM : Role.BAD), false);
  }

  /** The figure, and below it how much of the limit that is. */
  private void effort(GC gc, Rectangle at, JointRow row) {
    text.cell(gc, at, JointColumn.EFFORT.text(row), Face.FIGURES, theme.color(Role.TEXT), true);
    double share = row.effortShare();
    if (!Double.isNaN(share)) {
      int top = at.y + at.height - LOAD - 1;
      gc.setAntialias(SWT.OFF);
      gc.setBackground(theme.mix(Role.LINE, Role.PANEL, 0.9));
      gc.fillRectangle(at.x, top, at.width, LOAD);
      gc.setBackground(theme.color(share >= 1 ? Role.BAD : share >= HIGH_LOAD ? Role.WARNING : Role.ACCENT));
      gc.fillRectangle(at.x, top, (int) Math.round(at.width * share), LOAD);
    }
  }
}
