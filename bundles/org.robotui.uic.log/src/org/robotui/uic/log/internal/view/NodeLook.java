package org.robotui.uic.log.internal.view;

import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.RowLook;
import org.robotui.uic.log.internal.model.LogFilter;
import org.robotui.uic.log.internal.model.OriginCount;

/** Paints a node with a mark where it is shown, and how much it said. Display thread. */
final class NodeLook implements RowLook<OriginCount> {
  static final int MARK = 32;

  private static final int ROW = 24;
  private static final int ICON = 14;

  private final Theme theme;
  private LogFilter filter = LogFilter.ALL;

  NodeLook(Theme theme) {
    this.theme = theme;
  }

  void filter(LogFilter next) {
    filter = next;
  }

  @Override
  public Object key(OriginCount node) {
    return node.origin();
  }

  @Override
  public String text(OriginCount node) {
    return node.origin() + "\t" + node.count() + "\t" + (filter.shows(node.origin()) ? "shown" : "hidden");
  }

  @Override
  public int height() {
    return ROW;
  }

  @Override
  public String hint(GC gc, Rectangle at, OriginCount node, int x) {
    return node.origin() + (filter.shows(node.origin()) ? " is shown" : " is hidden");
  }

  @Override
  public void paint(GC gc, Rectangle at, OriginCount node) {
    boolean shown = filter.shows(node.origin());
    gc.setForeground(theme.color(Role.ACCENT));
    if (shown) {
      Icons.paint(gc, Icon.CHECK, at.x + Theme.EDGE, at.y + (at.height - ICON) / 2, ICON);
    }
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    String count = Integer.toString(node.count());
    Point size = gc.textExtent(count);
    int right = at.x + at.width - Theme.EDGE - size.x;
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(count, right, at.y + (at.height - size.y) / 2, true);
    gc.setFont(theme.font(Face.BODY));
    String name = TextFit.shorten(gc, node.origin(), right - at.x - MARK - Theme.STEP);
    gc.setForeground(theme.color(shown ? Role.TEXT : Role.DIM));
    gc.drawText(name, at.x + MARK, at.y + (at.height - gc.textExtent(name).y) / 2, true);
  }
}
