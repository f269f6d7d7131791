package org.robotui.uic.postures.internal.view;

import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.RowLook;
import org.robotui.ui.control.RowWords;
import org.robotui.uic.postures.internal.model.PostureLine;
import org.robotui.uic.postures.internal.model.PostureLine.Standing;

/** How postures look in the list, and the headings above them. Display thread. */
final class PostureColumns implements RowLook<PostureLine> {
  private static final int ROW = 28;
  private static final int HEADING = 24;
  private static final int NUMBER = 56;
  private static final int TIME = 64;
  private static final int LEAST_NAME = 120;
  private static final int WIDEST_AWAY = 220;
  private static final int PADDING = 2 * Theme.STEP;

  private final Theme theme;
  private final RowWords words;

  PostureColumns(Theme theme) {
    this.theme = theme;
    words = new RowWords(theme);
  }

  /** Makes the headings. */
  void heading(Composite parent) {
    PaintedCanvas canvas = new PaintedCanvas(parent, theme, (gc, area) -> {
      Rectangle inner = new Rectangle(0, 0, area.width, area.height - 1);
      heading(gc, number(inner), "#", true);
      heading(gc, name(inner), "Posture", false);
      heading(gc, time(inner), "Duration", true);
      heading(gc, away(inner), "Farthest joint (rad, m)", false);
      gc.setForeground(theme.color(Role.LINE));
      gc.drawLine(0, area.height - 1, area.width, area.height - 1);
    });
    canvas.setLayoutData(Boxes.line(HEADING));
  }

  private void heading(GC gc, Rectangle cell, String title, boolean right) {
    words.cell(gc, cell, title, Face.SMALL, theme.color(Role.DIM), right);
  }

  @Override
  public Object key(PostureLine line) {
    return line.index();
  }

  @Override
  public int height() {
    return ROW;
  }

  @Override
  public String text(PostureLine line) {
    return String.join("\t", Integer.toString(line.index() + 1), line.posture().name(), line.time(), line.away());
  }

  @Override
  public String hint(GC gc, Rectangle at, PostureLine line, int x) {
    return switch (line.standing()) {
      case HERE -> "The joints are at " + line.posture().name();
      case TARGET -> "On the way to " + line.posture().name();
      case FAILED -> line.posture().name() + " was not reached";
      case ELSEWHERE -> line.posture().joints().size() + " joints; Enter or a double-click goes there";
    };
  }

  @Override
  public void paint(GC gc, Rectangle at, PostureLine line) {
    Health health = switch (line.standing()) {
      case HERE -> Health.OK;
      case TARGET -> Health.WAITING;
      case FAILED -> Health.BAD;
      case ELSEWHERE -> Health.NONE;
    };
    if (line.standing() != Standing.ELSEWHERE) {
      HealthDot.paint(gc, theme, health, at.x + PADDING + HealthDot.SIZE / 2, at.y + at.height / 2);
    }
    words.cell(gc, number(at), Integer.toString(line.index() + 1), Face.FIGURES, theme.color(Role.DIM), true);
    words.cell(gc, name(at), line.posture().name(),
        line.standing() == Standing.TARGET ? Face.BODY_STRONG : Face.BODY, theme.color(Role.TEXT), false);
    words.cell(gc, time(at), line.time(), Face.FIGURES, theme.color(Role.TEXT), true);
    words.cell(gc, away(at), line.away(), Face.FIGURES, theme.color(Role.DIM), false);
  }

  private static Rectangle number(Rectangle row) {
    return new Rectangle(row.x, row.y, NUMBER - PADDING, row.height);
  }

  private static Rectangle name(Rectangle row) {
    return new Rectangle(row.x + NUMBER, row.y, Math.max(0, row.width - NUMBER - TIME - awayWidth(row) - PADDING),
        row.height);
  }

  private static Rectangle time(Rectangle row) {
    return new Rectangle(row.x + row.width - awayWidth(row) - TIME, row.y, TIME - PADDING, row.height);
  }

  private static Rectangle away(Rectangle row) {
    int width = awayWidth(row);
    return new Rectangle(row.x + row.width - width + PADDING, row.y, Math.max(0, width - 2 * PADDING), row.height);
  }

  /** What the name leaves. */
  private static int awayWidth(Rectangle row) {
    return Math.clamp(row.width - NUMBER - TIME - LEAST_NAME, 0, WIDEST_AWAY);
  }
}
