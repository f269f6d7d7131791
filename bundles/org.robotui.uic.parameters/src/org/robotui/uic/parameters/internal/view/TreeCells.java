package org.robotui.uic.parameters.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Column;
import org.robotui.uic.parameters.internal.model.ParameterRow;

/** The cells of the tree of parameters. It remembers where values were painted, for editing there. Display thread. */
final class TreeCells {
  private static final int INDENT = 16;
  private static final int TWIST = 12;

  private final Theme theme;
  private Optional<Rectangle> column = Optional.empty();

  TreeCells(Theme theme) {
    this.theme = theme;
  }

  List<Column<ParameterRow>> columns() {
    return List.of(
        Column.<ParameterRow>words("Name", ParameterRow::label).weight(5).painted(this::name)
            .hint(row -> row.key().name()),
        Column.<ParameterRow>values("Value", ParameterRow::text).weight(5).painted(this::value).hint(TreeCells::hint),
        Column.<ParameterRow>words("Type", ParameterRow::type).width(92).role(Role.DIM).from(420).unsearched());
  }

  /** Left of it, a click opens or shuts. */
  static int lead(ParameterRow row) {
    return 2 * Theme.STEP + row.depth() * INDENT + TWIST + Theme.STEP;
  }

  /** Where values stand, from left to right; none before the first paint. */
  Optional<Rectangle> column() {
    return column;
  }

  private void name(GC gc, Rectangle at, ParameterRow row) {
    int left = at.x + row.depth() * INDENT;
    if (row.namespace()) {
      gc.setForeground(theme.color(Role.DIM));
      Icons.paint(gc, row.open() ? Icon.OPEN : Icon.CLOSED, left, at.y + (at.height - TWIST) / 2, TWIST);
    }
    left += TWIST + Theme.STEP;
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(Role.TEXT));
    String label = TextFit.shorten(gc, row.label(), at.x + at.width - left);
    int y = at.y + (at.height - gc.textExtent("X").y) / 2;
    gc.drawText(label, left, y, true);
    if (row.namespace()) {
      left += gc.textExtent(label).x + 2 * Theme.STEP;
      gc.setFont(theme.font(Face.SMALL));
      gc.setForeground(theme.color(Role.DIM));
      String count = Integer.toString(row.leaves());
      if (left + gc.textExtent(count).x <= at.x + at.width) {
        gc.drawText(count, left, at.y + (at.height - gc.textExtent(count).y) / 2, true);
      }
    }
  }

  private void value(GC gc, Rectangle at, ParameterRow row) {
    if (column.filter(known -> known.x == at.x && known.width == at.width).isEmpty()) {
      column = Optional.of(new Rectangle(at.x, 0, at.width, at.height));
    }
    gc.setFont(theme.font(Face.FIGURES));
    gc.setForeground(theme.color(switch (row.state()) {
      case KNOWN -> Role.TEXT;
      case BUSY -> Role.DIM;
      case CHANGED -> Role.ACCENT;
      case WRONG -> Role.BAD;
    }));
    String text = row.text().replace('\n', ' ').replace('\t', ' ');
    gc.drawText(TextFit.shorten(gc, text, at.width), at.x, at.y + (at.height - gc.textExtent("X").y) / 2, true);
  }

  private static String hint(ParameterRow row) {
    return row.before().map(before -> row.text() + "\nwas " + before + " when it was first read").orElse(row.text());
  }
}
