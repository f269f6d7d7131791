package org.robotui.uic.status.internal;

import java.util.List;
import java.util.stream.Stream;
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
final class RowPainter implements RowLook<StatusRow> {
  private static final int ROW = 30;

  private static final int CHARGE_WIDTH = 64;
  private static final int CHARGE_HEIGHT = 8;
  private static final int CHARGE_TEXT = 40;
  /** The names of as many lines are measured; more are seldom seen at once. */
  private static final int MEASURED = 60;

  private final Theme theme;
  private final RowWords words;
  private List<String> names = List.of();
  private int longest = -1;

  RowPainter(Theme theme) {
    this.theme = theme;
    words = new RowWords(theme);
  }

  /** Makes room for the names of lines. */
  void show(List<StatusRow> rows) {
    List<String> next = rows.stream().limit(MEASURED).flatMap(row -> switch (row) {
      case StatusRow.Item item -> Stream.of(item.name());
      case StatusRow.Charge charge -> Stream.of(charge.name());
      default -> Stream.empty();
    }).toList();
    if (!next.equals(names)) {
      names = next;
      longest = -1;
    }
  }

  private Columns columns(GC gc, Rectangle at) {
    if (longest < 0) {
      gc.setFont(theme.font(Face.BODY));
      longest = names.stream().mapToInt(name -> gc.textExtent(name).x).max().orElse(0);
    }
    return Columns.of(at.width, longest);
  }

  @Override
  public int height() {
    return ROW;
  }

  @Override
  public Object key(StatusRow row) {
    return row.key();
  }

  @Override
  public String text(StatusRow row) {
    return row.details();
  }

  @Override
  public String hint(GC gc, Rectangle at, StatusRow row, int x) {
    return row instanceof StatusRow.Head ? "" : row.details();
  }

  @Override
  public void paint(GC gc, Rectangle at, StatusRow row) {
    gc.setForeground(theme.color(Role.LINE));
    gc.setLineWidth(1);
    gc.drawLine(at.x + Theme.EDGE, at.y + at.height - 1, at.x + at.width - Theme.EDGE, at.y + at.height - 1);
    switch (row) {
      case StatusRow.Head head -> words.text(gc, at, Theme.EDGE, at.width - 2 * Theme.EDGE, head.key(),
          Face.SMALL_STRONG, Role.DIM);
      case StatusRow.Note note -> note(gc, at, note);
      case StatusRow.Item item -> item(gc, at, item);
      case StatusRow.Charge charge -> charge(gc, at, charge);
    }
  }

  private void note(GC gc, Rectangle at, StatusRow.Note note) {
    dot(gc, at, Health.WARNING);
    words.text(gc, at, Columns.LEAD, at.width - Columns.LEAD - Theme.EDGE, note.details(), Face.BODY, note.role());
  }

  private void item(GC gc, Rectangle at, StatusRow.Item item) {
    dot(gc, at, item.health());
    Columns columns = columns(gc, at);
    name(gc, at, columns, item.name(), item.health());
    words.right(gc, at, columns.nameEnd(), Columns.WORD, item.word(), wordRole(item.health()));
    int x = columns.plainValue();
    // What has neither age nor losses is a sentence: it needs the room, and nothing can jump.
    boolean told = !item.age().isEmpty() || !item.dropped().isEmpty();
    if (told && columns.age()) {
      words.right(gc, at, x, Columns.AGE, item.age(), item.health() == Health.STALE ? Role.WARNING : Role.DIM);
      x += Columns.AGE + Columns.GAP;
    }
    if (told && columns.dropped()) {
      words.right(gc, at, x, Columns.DROPPED, item.dropped(), Role.WARNING);
      x += Columns.DROPPED + Columns.GAP;
    }
    boolean figures = item.health() == Health.OK || item.health() == Health.STALE;
    Role role = item.health() == Health.BAD ? Role.BAD : item.health() == Health.OK ? Role.TEXT : Role.DIM;
    if (columns.value() > 0) {
      words.text(gc, at, x, at.width - x - Theme.EDGE, item.value(), figures ? Face.FIGURES : Face.BODY, role);
    }
  }

  private void charge(GC gc, Rectangle at, StatusRow.Charge charge) {
    dot(gc, at, charge.health());
    Columns columns = columns(gc, at);
    name(gc, at, columns, charge.name(), charge.health());
    int x = columns.nameEnd();
    boolean bar = at.width - x - Theme.EDGE >= CHARGE_WIDTH + Columns.GAP + CHARGE_TEXT;
    if (bar && !Double.isNaN(charge.charge())) {
      bar(gc, at.x + x, at.y + (at.height - CHARGE_HEIGHT) / 2, charge.charge(), charge.health());
    }
    x += bar ? CHARGE_WIDTH + Columns.GAP : 0;
    words.first(gc, at, x, at.width - x - Theme.EDGE, charge.texts(),
        charge.health() == Health.OK ? Role.TEXT : charge.health().role());
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

  private void name(GC gc, Rectangle at, Columns columns, String name, Health health) {
    int room = columns.nameEnd() - Columns.LEAD - Columns.GAP;
    words.name(gc, at, Columns.LEAD, room, name, Face.BODY, health == Health.NONE ? Role.DIM : Role.TEXT);
  }

  private static Role wordRole(Health health) {
    return switch (health) {
      case OK -> Role.TEXT;
      case WAITING, NONE -> Role.DIM;
      default -> health.role();
    };
  }
}
