package org.robotui.uic.diagnostics.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.RowLook;
import org.robotui.uic.diagnostics.internal.model.DiagnosticsRow;
import org.robotui.uic.diagnostics.internal.model.Level;

/** Paints a line of the tree: arrow, dot, name, word, message, and how it was. Display thread. */
final class TreeLook implements RowLook<DiagnosticsRow> {
  private static final int INDENT = 18;
  private static final int ARROW = 20;
  private static final int WORD = 62;
  private static final int STRIP = 150;
  private static final int STRIP_INSET = 6;
  private static final int ROOM_FOR_STRIP = 460;
  private static final int ROOM_FOR_MESSAGE = 330;
  private static final int ROOM_FOR_WORD = 220;
  private static final int WIDEST_NAME = 340;
  private static final double NAME_SHARE = 0.38;
  private static final double LINE_SHARE = 0.55;

  private final Theme theme;
  private final StripPainter strips;
  private Optional<Long> moment = Optional.empty();

  TreeLook(Theme theme) {
    this.theme = theme;
    this.strips = new StripPainter(theme);
  }

  void moment(Optional<Long> slot) {
    moment = slot;
  }

  @Override
  public Object key(DiagnosticsRow row) {
    return row.key();
  }

  @Override
  public String text(DiagnosticsRow row) {
    return row.label() + "\t" + row.level().word() + "\t" + row.message();
  }

  @Override
  public String hint(GC gc, Rectangle at, DiagnosticsRow row, int x) {
    if (strip(at).filter(s -> x >= s.x).isPresent()) {
      return "The history; a click shows that moment";
    }
    return row.label() + ": " + row.level().word() + (row.message().isBlank() ? "" : "\n" + row.message());
  }

  /** Whether a place of a line is its arrow. */
  static boolean isArrow(DiagnosticsRow row, int x) {
    int left = Theme.EDGE + row.depth() * INDENT;
    return row.group() && x >= left - 6 && x < left + ARROW - 6;
  }

  /** Where the strip of a line is, none where there is no room. */
  static Optional<Rectangle> strip(Rectangle at) {
    return at.width < ROOM_FOR_STRIP ? Optional.empty()
        : Optional.of(new Rectangle(at.x + at.width - Theme.EDGE - STRIP, at.y + STRIP_INSET, STRIP,
            at.height - 2 * STRIP_INSET));
  }

  @Override
  public void paint(GC gc, Rectangle at, DiagnosticsRow row) {
    gc.setForeground(theme.mix(Role.LINE, Role.PANEL, LINE_SHARE));
    gc.setLineWidth(1);
    gc.drawLine(at.x + Theme.EDGE, at.y + at.height - 1, at.x + at.width - Theme.EDGE, at.y + at.height - 1);
    int left = at.x + Theme.EDGE + row.depth() * INDENT;
    if (row.group()) {
      arrow(gc, left + 3, at.y + at.height / 2, row.open());
    }
    left += ARROW - 6;
    HealthDot.paint(gc, theme, Levels.health(row.level()), left + HealthDot.SIZE / 2, at.y + at.height / 2);
    left += HealthDot.SIZE + 2 * Theme.STEP;
    Optional<Rectangle> strip = strip(at);
    int right = strip.map(s -> s.x - Theme.EDGE).orElse(at.x + at.width - Theme.EDGE);
    boolean message = at.width >= ROOM_FOR_MESSAGE;
    if (at.width < ROOM_FOR_WORD) {
      words(gc, at, left, right - left, row.label(), row.group() ? Face.BODY_STRONG : Face.BODY, Role.TEXT);
      return;
    }
    int end = message ? at.x + Math.min(WIDEST_NAME, (int) (at.width * NAME_SHARE)) : right - WORD - Theme.EDGE;
    words(gc, at, left, end - left, row.label(), row.group() ? Face.BODY_STRONG : Face.BODY, Role.TEXT);
    int word = end + Theme.EDGE;
    words(gc, at, word, WORD, row.level().word(), Face.BODY,
        row.level() == Level.OK ? Role.DIM : Levels.health(row.level()).role());
    if (message) {
      words(gc, at, word + WORD, right - word - WORD, row.message(), Face.BODY,
          row.level().problem() ? Role.TEXT : Role.DIM);
    }
    strip.ifPresent(s -> strips.paint(gc, s, row.strip(), moment));
  }

  private void arrow(GC gc, int x, int y, boolean open) {
    gc.setAntialias(SWT.ON);
    gc.setForeground(theme.color(Role.DIM));
    gc.setLineWidth(2);
    int[] points =
        open ? new int[]{x - 4, y - 2, x, y + 2, x + 4, y - 2} : new int[]{x - 2, y - 4, x + 2, y, x - 2, y + 4};
    gc.drawPolyline(points);
    gc.setLineWidth(1);
  }

  private void words(GC gc, Rectangle at, int x, int width, String text, Face face, Role role) {
    gc.setFont(theme.font(face));
    String shown = TextFit.shorten(gc, text.replace('\n', ' '), Math.max(0, width));
    gc.setForeground(theme.color(role));
    gc.drawText(shown, x, at.y + (at.height - gc.textExtent(shown).y) / 2, true);
  }
}
