package org.robotui.uic.plugins.internal.view;

import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.RowLook;
import org.robotui.ui.control.RowWords;
import org.robotui.uic.plugins.internal.model.DrivesLine;
import org.robotui.uic.plugins.internal.model.Line;
import org.robotui.uic.plugins.internal.model.LoopLine;
import org.robotui.uic.plugins.internal.model.PluginColumn.Place;
import org.robotui.uic.plugins.internal.model.PluginColumn;
import org.robotui.uic.plugins.internal.model.PluginLine;

/** How threads and plugins look in the list. Display thread. */
final class ListLook implements RowLook<Line> {
  static final int PADDING = 2 * Theme.STEP;

  private static final int ROW = 28;
  private static final int DOT = HealthDot.SIZE + 2 * Theme.STEP;
  private static final double GROUND = 0.55;

  private final Theme theme;
  private final RowWords text;
  private final BudgetBar budget;
  private final SwitchPaint switches;
  private Map<PluginColumn, Place> places = Map.of();
  private int width = -1;
  private boolean usable;

  ListLook(Theme theme) {
    this.theme = theme;
    text = new RowWords(theme);
    budget = new BudgetBar(theme);
    switches = new SwitchPaint(theme);
  }

  /** Where the columns stand in a width. */
  Map<PluginColumn, Place> places(int room) {
    if (width != room) {
      width = room;
      places = PluginColumn.places(room);
    }
    return places;
  }

  /** The column at a place. */
  Optional<PluginColumn> at(int room, int x) {
    return places(room).entrySet().stream()
        .filter(e -> x >= e.getValue().left() && x < e.getValue().left() + e.getValue().width())
        .map(Map.Entry::getKey).findFirst();
  }

  /** Whether plugins can be switched at all. */
  void usable(boolean now) {
    usable = now;
  }

  @Override
  public Object key(Line line) {
    return line.key();
  }

  @Override
  public int height() {
    return ROW;
  }

  @Override
  public String text(Line line) {
    return Stream.of(PluginColumn.values()).map(column -> column.text(line)).filter(words -> !words.isEmpty())
        .collect(Collectors.joining("\t"));
  }

  @Override
  public String hint(GC gc, Rectangle at, Line line, int x) {
    return at(at.width, x - at.x).map(column -> switch (column) {
      case SWITCH -> line instanceof PluginLine plugin ? switchHint(plugin) : "";
      case BUDGET -> "Of its period a call took p50, p99 and at most this much";
      case STATE, NAME -> line instanceof LoopLine loop ? loop.scheduled() : line.name() + ", " + line.word();
      case WORDS -> line.words();
      case P50, P99, MAX -> "";
    }).orElse("");
  }

  private String switchHint(PluginLine line) {
    if (!usable) {
      return "Plugins cannot be switched now: no control is connected that switches them, or it is silent";
    }
    return line.isTurning() ? line.name() + " is " + line.word()
        : !line.isSwitchable() ? line.name() + " must be loaded first"
            : (line.isOn() ? "Stop " : "Start ") + line.name();
  }

  @Override
  public void paint(GC gc, Rectangle at, Line line) {
    if (line instanceof LoopLine) {
      gc.setBackground(theme.mix(Role.TITLE, Role.PANEL, GROUND));
      gc.fillRectangle(at.x, at.y, at.width, 1);
    }
    places(at.width).forEach(
        (column, place) -> cell(gc, new Rectangle(at.x + place.left(), at.y, place.width(), at.height), column, line));
  }

  private void cell(GC gc, Rectangle cell, PluginColumn column, Line line) {
    Rectangle at = new Rectangle(cell.x + PADDING, cell.y, Math.max(0, cell.width - 2 * PADDING), cell.height);
    switch (column) {
      case SWITCH -> control(gc, cell, line);
      case NAME -> name(gc, at, line);
      case BUDGET -> budget.paint(gc, at, line);
      default -> text.cell(gc, at, column.text(line), column.isFigure() ? Face.FIGURES : Face.BODY, ink(column, line),
          column.isFigure());
    }
  }

  private void control(GC gc, Rectangle cell, Line line) {
    switch (line) {
      case PluginLine plugin -> switches.paint(gc, cell, plugin, usable);
      case LoopLine loop -> HealthDot.paint(gc, theme, loop.health(), cell.x + cell.width / 2,
          cell.y + cell.height / 2);
      case DrivesLine drives -> {}
    }
  }

  /**
   * A thread is named where the switches of its plugins stand; what is below it is set in a little, each with its dot.
   */
  private void name(GC gc, Rectangle at, Line line) {
    switch (line) {
      case LoopLine loop -> text.cell(gc, at, loop.name(), Face.BODY_STRONG, theme.color(Role.TEXT), false);
      case PluginLine part -> set(gc, at, part);
      case DrivesLine part -> set(gc, at, part);
    }
  }

  private void set(GC gc, Rectangle at, Line part) {
    HealthDot.paint(gc, theme, part.health(), at.x + HealthDot.SIZE / 2, at.y + at.height / 2);
    text.cell(gc, new Rectangle(at.x + DOT, at.y, Math.max(0, at.width - DOT), at.height), part.name(), Face.BODY,
        theme.color(Role.TEXT), false);
  }

  private Color ink(PluginColumn column, Line line) {
    boolean bad = line.health() == Health.BAD && (column == PluginColumn.STATE || column == PluginColumn.WORDS);
    boolean quiet = column == PluginColumn.WORDS || line instanceof LoopLine && column == PluginColumn.STATE
        || line.health() == Health.NONE;
    return theme.color(bad ? Role.BAD : quiet ? Role.DIM : Role.TEXT);
  }
}
