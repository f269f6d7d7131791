package org.robotui.uic.connections.internal.view;

import java.util.function.Predicate;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.RowLook;
import org.robotui.ui.control.RowWords;
import org.robotui.uic.connections.internal.model.ConnectionLine;

/** Paints lines in columns that stay where they are while the values change. Display thread. */
final class LineLook implements RowLook<ConnectionLine> {
  /** How far each level is set in. */
  static final int INDENT = 12;

  private static final int FOLD = 14;
  private static final int WORD = 84;
  private static final int AGE = 64;
  private static final int DROPPED = 92;
  private static final int GAP = 10;
  private static final int ROOM_FOR_DROPPED = 680;
  private static final int ROOM_FOR_AGE = 560;
  private static final double NAME_SHARE = 0.34;
  private static final double NARROW_NAME_SHARE = 0.46;
  private static final int WIDEST_NAME = 420;

  private final Theme theme;
  private final RowWords words;
  private final Predicate<ConnectionLine> folded;

  LineLook(Theme theme, Predicate<ConnectionLine> folded) {
    this.theme = theme;
    words = new RowWords(theme);
    this.folded = folded;
  }

  /** Where the text of a line begins; what folds it lies to the left of that. */
  static int lead(ConnectionLine line) {
    return Theme.EDGE + line.level() * INDENT + FOLD;
  }

  @Override
  public Object key(ConnectionLine row) {
    return row.key();
  }

  @Override
  public String text(ConnectionLine row) {
    return row.details();
  }

  @Override
  public String hint(GC gc, Rectangle at, ConnectionLine row, int x) {
    return row.details();
  }

  @Override
  public void paint(GC gc, Rectangle at, ConnectionLine row) {
    line(gc, at, row);
    if (row.level() < 2) {
      fold(gc, at.x + lead(row) - FOLD, at.y + at.height / 2, folded.test(row));
    }
    HealthDot.paint(gc, theme, row.health(), at.x + lead(row) + HealthDot.SIZE / 2, at.y + at.height / 2);
    int left = lead(row) + HealthDot.SIZE + 2 * Theme.STEP;
    int end = Math.max(left,
        Math.min(WIDEST_NAME, (int) (at.width * (at.width >= ROOM_FOR_AGE ? NAME_SHARE : NARROW_NAME_SHARE))));
    words.name(gc, at, left, end - left, row.name(), row.level() == 0 ? Face.BODY_STRONG : Face.BODY,
        row.health() == Health.NONE && row.level() == 2 ? Role.DIM : Role.TEXT);
    int x = end + GAP;
    words.right(gc, at, x, WORD, row.word(), wordRole(row));
    x += WORD + GAP;
    if (at.width >= ROOM_FOR_AGE) {
      words.right(gc, at, x, AGE, row.age().isEmpty() ? row.since() : row.age(),
          row.health() == Health.STALE ? Role.WARNING : Role.DIM);
      x += AGE + GAP;
    }
    if (at.width >= ROOM_FOR_DROPPED) {
      words.right(gc, at, x, DROPPED, row.dropped(), Role.WARNING);
      x += DROPPED + GAP;
    }
    words.text(gc, at, x, at.width - x - Theme.EDGE, row.text(), Face.BODY, textRole(row));
  }

  private void line(GC gc, Rectangle at, ConnectionLine row) {
    gc.setForeground(theme.mix(Role.LINE, Role.PANEL, row.level() == 0 ? 1 : 0.5));
    gc.setLineWidth(1);
    int y = row.level() == 0 ? at.y : at.y + at.height - 1;
    gc.drawLine(at.x + Theme.EDGE, y, at.x + at.width - Theme.EDGE, y);
  }

  private void fold(GC gc, int x, int y, boolean shut) {
    gc.setBackground(theme.color(Role.DIM));
    gc.fillPolygon(
        shut ? new int[]{x + 1, y - 4, x + 6, y, x + 1, y + 4} : new int[]{x, y - 2, x + 8, y - 2, x + 4, y + 3});
  }

  private static Role wordRole(ConnectionLine row) {
    if (row instanceof ConnectionLine.Part && row.word().equals(ConnectionLine.VIEW)) {
      return Role.DIM;
    }
    return switch (row.health()) {
      case OK -> row.level() == 2 ? Role.TEXT : Role.DIM;
      case WAITING, NONE -> Role.DIM;
      default -> row.health().role();
    };
  }

  private static Role textRole(ConnectionLine row) {
    boolean own = row.level() == 2 || row.isProblem();
    return switch (row.health()) {
      case BAD -> own ? Role.BAD : Role.DIM;
      case WARNING, OK -> own ? Role.TEXT : Role.DIM;
      default -> Role.DIM;
    };
  }
}
