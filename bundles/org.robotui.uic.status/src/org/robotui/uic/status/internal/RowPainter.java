package org.robotui.uic.status.internal;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.RowLook;
import org.robotui.ui.control.RowWords;

/** Paints lines in columns that stay where they are while the values change. Display thread. */
final class RowPainter implements RowLook<Row> {
  private static final int ROW = 30;

  private static final int LEAD = Theme.EDGE + HealthDot.SIZE + 2 * Theme.STEP;
  private static final int WORD = 84;
  private static final int AGE = 52;
  private static final int DROPPED = 92;
  private static final int GAP = 8;
  private static final int ROOM_FOR_DROPPED = 620;
  private static final int ROOM_FOR_AGE = 440;
  private static final int CHARGE_WIDTH = 64;
  private static final int CHARGE_HEIGHT = 8;
  private static final double NAME_SHARE = 0.3;
  private static final double NARROW_NAME_SHARE = 0.32;

  private final Theme theme;
  private final RowWords words;

  RowPainter(Theme theme) {
    this.theme = theme;
    words = new RowWords(theme);
  }

  @Override
  public int height() {
    return ROW;
  }

  @Override
  public Object key(Row row) {
    return row.key();
  }

  @Override
  public String text(Row row) {
    return row.details();
  }

  @Override
  public String hint(GC gc, Rectangle at, Row row, int x) {
    return row instanceof Row.Head ? "" : row.details();
  }

  @Override
  public void paint(GC gc, Rectangle at, Row row) {
    gc.setForeground(theme.color(Role.LINE));
    gc.setLineWidth(1);
    gc.drawLine(at.x + Theme.EDGE, at.y + at.height - 1, at.x + at.width - Theme.EDGE, at.y + at.height - 1);
    switch (row) {
      case Row.Head head -> words.text(gc, at, Theme.EDGE, at.width - 2 * Theme.EDGE, head.key(), Face.SMALL_STRONG, Role.DIM);
      case Row.Note note -> note(gc, at, note);
      case Row.Item item -> item(gc, at, item);
      case Row.Charge charge -> charge(gc, at, charge);
    }
  }

  private void note(GC gc, Rectangle at, Row.Note note) {
    dot(gc, at, Health.WARNING);
    words.text(gc, at, LEAD, at.width - LEAD - Theme.EDGE, note.details(), Face.BODY, note.role());
  }

  private void item(GC gc, Rectangle at, Row.Item item) {
    dot(gc, at, item.health());
    int x = name(gc, at, item.name(), item.health());
    words.right(gc, at, x, WORD, item.word(), wordRole(item.health()));
    x += WORD + GAP;
    // What has neither age nor losses is a sentence: it needs the room, and nothing can jump.
    boolean columns = !item.age().isEmpty() || !item.dropped().isEmpty();
    if (columns && at.width >= ROOM_FOR_AGE) {
      words.right(gc, at, x, AGE, item.age(), item.health() == Health.STALE ? Role.WARNING : Role.DIM);
      x += AGE + GAP;
    }
    if (columns && at.width >= ROOM_FOR_DROPPED) {
      words.right(gc, at, x, DROPPED, item.dropped(), Role.WARNING);
      x += DROPPED + GAP;
    }
    boolean figures = item.health() == Health.OK || item.health() == Health.STALE;
    Role role = item.health() == Health.BAD ? Role.BAD : item.health() == Health.OK ? Role.TEXT : Role.DIM;
    words.text(gc, at, x, at.width - x - Theme.EDGE, item.value(), figures ? Face.FIGURES : Face.BODY, role);
  }

  private void charge(GC gc, Rectangle at, Row.Charge charge) {
    dot(gc, at, charge.health());
    int x = name(gc, at, charge.name(), charge.health());
    if (!Double.isNaN(charge.charge())) {
      bar(gc, at.x + x, at.y + (at.height - CHARGE_HEIGHT) / 2, charge.charge(), charge.health());
    }
    x += CHARGE_WIDTH + GAP;
    words.first(gc, at, x, at.width - x - Theme.EDGE, charge.texts(), charge.health() == Health.OK ? Role.TEXT : charge.health().role());
  }

  private void bar(GC gc, int x, int y, double share, Health health) {
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.color(theme.dark() ? Role.GROUND : Role.LINE));
    gc.fillRoundRectangle(x, y, CHARGE_WIDTH, CHARGE_HEIGHT, CHARGE_HEIGHT, CHARGE_HEIGHT);
    gc.setBackground(theme.color(health.role()));
    int filled = (int) Math.round(CHARGE_WIDTH * share);
    gc.fillRoundRectangle(x, y, Math.max(filled, CHARGE_HEIGHT), CHARGE_HEIGHT, CHARGE_HEIGHT, CHARGE_HEIGHT);
  }

  private void dot(GC gc, Rectangle at, Health health) {
    HealthDot.paint(gc, theme, health, at.x + Theme.EDGE + HealthDot.SIZE / 2, at.y + at.height / 2);
  }

  private int name(GC gc, Rectangle at, String name, Health health) {
    int end = (int) (at.width * (at.width >= ROOM_FOR_AGE ? NAME_SHARE : NARROW_NAME_SHARE));
    words.name(gc, at, LEAD, end - LEAD - GAP, name, Face.BODY, health == Health.NONE ? Role.DIM : Role.TEXT);
    return end;
  }

  private static Role wordRole(Health health) {
    return switch (health) {
      case OK -> Role.TEXT;
      case WAITING, NONE -> Role.DIM;
      default -> health.role();
    };
  }
}
