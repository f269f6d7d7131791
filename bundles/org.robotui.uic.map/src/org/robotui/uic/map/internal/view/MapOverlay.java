package org.robotui.uic.map.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.entity.grid.ScaleBar;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.layer.LayerNote;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.ui.scene.Viewport;
import org.robotui.uic.map.internal.model.MapSnapshot;

/** What lies over the map and does not move with it. Display thread. */
final class MapOverlay {
  private static final int PILL_HEIGHT = 24;
  /** Below the place where stale data say their age. */
  private static final int HINT_TOP = 2 * Theme.EDGE + PILL_HEIGHT;
  private static final int CARD_ROW = 18;
  private static final int CARD_OFFSET = 16;
  private static final String WIDEST_PLACE = "x \u2212000.00  y \u2212000.00 m";

  private final Theme theme;
  private final StateView states;
  private final NoteList list;

  MapOverlay(Theme theme) {
    this.theme = theme;
    this.states = new StateView(theme);
    this.list = new NoteList(theme, states);
  }

  void corners(GC gc, Viewport viewport, MapSnapshot snapshot, Optional<Point> pointer) {
    ScaleBar.paint(gc, theme, viewport);
    String frame = snapshot.fixed().map(f -> f.name() + "   ").orElse("");
    String place = pointer
        .map(
            p -> "x " + Figures.fixed(viewport.worldX(p.x), 2) + "  y " + Figures.fixed(viewport.worldY(p.y), 2) + " m")
        .orElse("");
    if (!(frame + place).isBlank()) {
      coordinates(gc, viewport, frame, place);
    }
  }

  /**
   * Lines about layers, top left.
   *
   * @param banner whether the age of stale data stands at the upper edge
   * @param hint whether a hint stands below that
   */
  void notes(GC gc, Rectangle area, List<LayerNote> notes, boolean banner, boolean hint) {
    int above = hint ? HINT_TOP + PILL_HEIGHT : banner ? Theme.EDGE + PILL_HEIGHT : 0;
    list.paint(gc, area, notes, above + Theme.EDGE);
  }

  void hint(GC gc, Rectangle area, String text) {
    gc.setFont(theme.font(Face.SMALL));
    Point size = gc.textExtent(text);
    Rectangle pill = centered(area, HINT_TOP, size.x + 2 * Theme.EDGE);
    states.pill(gc, pill);
    gc.setForeground(theme.color(Role.ACCENT));
    gc.drawText(text, pill.x + Theme.EDGE, pill.y + (PILL_HEIGHT - size.y) / 2, true);
  }

  void toast(GC gc, Rectangle area, CommandNotice told) {
    gc.setFont(theme.font(Face.BODY));
    String text = TextFit.shorten(gc, told.text(), area.width - 6 * Theme.EDGE);
    Point size = gc.textExtent(text);
    int lead = HealthDot.SIZE + 2 * Theme.STEP;
    int top = area.height - PILL_HEIGHT - 4 * Theme.EDGE;
    Rectangle pill = centered(area, top, size.x + lead + 2 * Theme.EDGE);
    states.pill(gc, pill);
    HealthDot.paint(gc, theme, told.health(), pill.x + Theme.EDGE + HealthDot.SIZE / 2, pill.y + PILL_HEIGHT / 2);
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(text, pill.x + Theme.EDGE + lead, pill.y + (PILL_HEIGHT - size.y) / 2, true);
  }

  /** What is under the pointer, beside it and within the area. */
  void card(GC gc, Rectangle area, Point pointer, List<CardLine> lines) {
    gc.setFont(theme.font(Face.SMALL));
    int width = lines.stream().mapToInt(l -> gc.textExtent(l.text()).x).max().orElse(0) + 2 * Theme.EDGE;
    int height = lines.size() * CARD_ROW + 2 * Theme.STEP;
    int x = Math.max(0, Math.min(pointer.x + CARD_OFFSET, area.width - width - Theme.STEP));
    boolean above = pointer.y + CARD_OFFSET + height > area.height;
    int y = above ? pointer.y - CARD_OFFSET - height : pointer.y + CARD_OFFSET;
    states.pill(gc, new Rectangle(x, y, width, height));
    int top = y + Theme.STEP;
    for (int i = 0; i < lines.size(); i++) {
      CardLine line = lines.get(i);
      gc.setForeground(theme.color(line.strong() ? Role.TEXT : Role.DIM));
      int inset = (CARD_ROW - gc.textExtent(line.text()).y) / 2;
      gc.drawText(line.text(), x + Theme.EDGE, top + i * CARD_ROW + inset, true);
    }
  }

  private void coordinates(GC gc, Viewport viewport, String frame, String place) {
    gc.setFont(theme.font(Face.SMALL));
    int frameWidth = frame.isEmpty() ? 0 : gc.textExtent(frame).x;
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    Point size = gc.textExtent(place.isEmpty() ? "x" : WIDEST_PLACE);
    // As wide as it ever gets, so that it does not jump with the figures.
    int width = frameWidth + (place.isEmpty() ? 0 : Math.max(size.x, gc.textExtent(place).x)) + 2 * Theme.EDGE
        - (place.isEmpty() ? Theme.EDGE / 2 : 0);
    Rectangle pill = new Rectangle(Theme.EDGE, viewport.height() - Theme.EDGE - PILL_HEIGHT, width, PILL_HEIGHT);
    states.pill(gc, pill);
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(place, pill.x + Theme.EDGE + frameWidth, pill.y + (PILL_HEIGHT - size.y) / 2, true);
    gc.setFont(theme.font(Face.SMALL));
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(frame, pill.x + Theme.EDGE, pill.y + (PILL_HEIGHT - gc.textExtent(frame).y) / 2, true);
  }

  private static Rectangle centered(Rectangle area, int top, int width) {
    return new Rectangle((area.width - width) / 2, top, width, PILL_HEIGHT);
  }
}
