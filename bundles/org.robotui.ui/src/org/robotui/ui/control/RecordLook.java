package org.robotui.ui.control;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.data.record.FieldValue;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** How lines of the tree of a record look: names at the left, values in a column. Display thread. */
final class RecordLook implements RowLook<RecordRow> {
  private static final int ROW = 24;
  private static final int STEP_IN = 14;
  private static final int CHEVRON = 16;
  private static final double NAMES = 0.4;
  private static final int LONGEST_HINT = 2_000;
  private static final double LINE_SHARE = 0.55;

  private final Theme theme;
  private final CellPainter cells;

  RecordLook(Theme theme) {
    this.theme = theme;
    cells = new CellPainter(theme);
  }

  void search(String words) {
    cells.search(words);
  }

  @Override
  public int height() {
    return ROW;
  }

  @Override
  public Object key(RecordRow row) {
    return row.path();
  }

  @Override
  public String text(RecordRow row) {
    String value = RecordText.line(row);
    return value.isEmpty() ? row.path() : row.path() + ": " + value;
  }

  @Override
  public void paint(GC gc, Rectangle at, RecordRow row) {
    gc.setForeground(theme.mix(Role.LINE, Role.PANEL, LINE_SHARE));
    gc.setLineWidth(1);
    gc.drawLine(at.x + CellPainter.PADDING, at.y + at.height - 1, at.x + at.width - CellPainter.PADDING,
        at.y + at.height - 1);
    if (row.expandable()) {
      chevron(gc, at.x + chevronAt(row), at.y + at.height / 2, row.expanded());
    }
    Role ink = row.name().startsWith("[") ? Role.DIM : Role.TEXT;
    cells.words(gc, name(at, row), row.name(), row.name().startsWith("[") ? Face.FIGURES : Face.BODY, theme.color(ink),
        false, true);
    cells.words(gc, value(at), RecordText.line(row), face(row), theme.color(valueRole(row)), false, true);
  }

  @Override
  public String hint(GC gc, Rectangle at, RecordRow row, int x) {
    if (x < value(at).x) {
      return row.path();
    }
    String text = row.isPage() ? "" : RecordText.line(row.value());
    gc.setFont(theme.font(face(row)));
    boolean cut = text.length() > at.width || text.indexOf('\n') >= 0 || gc.textExtent(text).x > value(at).width;
    return cut ? text.substring(0, Math.min(LONGEST_HINT, text.length())) : "";
  }

  /** Whether a press there is one on the sign that opens and closes. */
  boolean isChevron(RecordRow row, int x) {
    return row.expandable() && x >= chevronAt(row) && x < chevronAt(row) + CHEVRON;
  }

  private static int chevronAt(RecordRow row) {
    return Theme.STEP + row.depth() * STEP_IN;
  }

  private static Rectangle name(Rectangle at, RecordRow row) {
    int left = chevronAt(row) + CHEVRON;
    return new Rectangle(at.x + left, at.y, Math.max(0, valueAt(at) - left - CellPainter.PADDING), at.height);
  }

  private static Rectangle value(Rectangle at) {
    int left = valueAt(at);
    return new Rectangle(at.x + left, at.y, Math.max(0, at.width - left - CellPainter.PADDING), at.height);
  }

  private static int valueAt(Rectangle at) {
    return (int) (at.width * NAMES);
  }

  private static Face face(RecordRow row) {
    return row.value() instanceof FieldValue.Nested || row.value() instanceof FieldValue.Text ? Face.BODY
        : Face.FIGURES;
  }

  private static Role valueRole(RecordRow row) {
    return row.expandable() || row.value() instanceof FieldValue.Items || row.value() instanceof FieldValue.Numbers
        ? Role.DIM
        : Role.TEXT;
  }

  private void chevron(GC gc, int x, int middle, boolean down) {
    gc.setAntialias(SWT.ON);
    gc.setForeground(theme.color(Role.DIM));
    gc.setLineWidth(2);
    int left = x + 4;
    gc.drawPolyline(down
        ? new int[]{left, middle - 2, left + 4, middle + 2, left + 8, middle - 2}
        : new int[]{left + 2, middle - 4, left + 6, middle, left + 2, middle + 4});
    gc.setLineWidth(1);
  }
}
