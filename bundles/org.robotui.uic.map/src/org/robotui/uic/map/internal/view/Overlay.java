package org.robotui.uic.map.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.entity.grid.ScaleBar;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.scene.Viewport;
import org.robotui.uic.map.internal.model.MapSnapshot;
import org.robotui.uic.map.internal.model.Note;

/** What lies over the map and does not move with it. Display thread. */
final class Overlay {
  private static final int PILL_HEIGHT = 24;
  private static final int MOST_NOTES = 5;
  private static final int NOTE_HEIGHT = 18;
  private static final int CARD_OFFSET = 16;
  private static final String WIDEST_PLACE = "x \u2212000.00  y \u2212000.00 m";

  private final Theme theme;
  private final StateView states;

  Overlay(Theme theme) {
    this.theme = theme;
    this.states = new StateView(theme);
  }

  void corners(GC gc, Viewport viewport, MapSnapshot snapshot, Optional<Point> pointer) {
    ScaleBar.paint(gc, theme, viewport);
    String frame = snapshot.fixed().map(f -> f.name() + "   ").orElse("");
    String place = pointer
        .map(p -> "x " + Figures.fixed(viewport.worldX(p.x), 2) + "  y " + Figures.fixed(viewport.worldY(p.y), 2) + " m")
        .orElse("");
    if (!(frame + place).isBlank()) {
      coordinates(gc, viewport, frame, place);
    }
  }

  /** Lines about layers, top left. */
  void notes(GC gc, Rectangle area, List<Note> notes) {
    gc.setFont(theme.font(Face.SMALL));
    int y = Theme.EDGE;
    for (Note note : notes.subList(0, Math.min(MOST_NOTES, notes.size()))) {
      y = line(gc, area, y, note.health(), note.text());
    }
    if (notes.size() > MOST_NOTES) {
      line(gc, area, y, Health.NONE, "and " + (notes.size() - MOST_NOTES) + " more");
    }
  }

  void hint(GC gc, Rectangle area, String text) {
    gc.setFont(theme.font(Face.SMALL));
    Point size = gc.textExtent(text);
    // Below the place where stale data say their age.
    Rectangle pill = centered(area, 2 * Theme.EDGE + PILL_HEIGHT, size.x + 2 * Theme.EDGE);
    states.pill(gc, pill);
    gc.setForeground(theme.color(Role.ACCENT));
    gc.drawText(text, pill.x + Theme.EDGE, pill.y + (PILL_HEIGHT - size.y) / 2, true);
  }

  void toast(GC gc, Rectangle area, Told told) {
    gc.setFont(theme.font(Face.BODY));
    String text = shortened(gc, told.text(), area.width - 6 * Theme.EDGE);
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
    int height = lines.size() * NOTE_HEIGHT + 2 * Theme.STEP;
    int x = Math.max(0, Math.min(pointer.x + CARD_OFFSET, area.width - width - Theme.STEP));
    boolean above = pointer.y + CARD_OFFSET + height > area.height;
    int y = above ? pointer.y - CARD_OFFSET - height : pointer.y + CARD_OFFSET;
    states.pill(gc, new Rectangle(x, y, width, height));
    int top = y + Theme.STEP;
    for (int i = 0; i < lines.size(); i++) {
      CardLine line = lines.get(i);
      gc.setForeground(theme.color(line.strong() ? Role.TEXT : Role.DIM));
      int inset = (NOTE_HEIGHT - gc.textExtent(line.text()).y) / 2;
      gc.drawText(line.text(), x + Theme.EDGE, top + i * NOTE_HEIGHT + inset, true);
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

  private int line(GC gc, Rectangle area, int y, Health health, String text) {
    String words = shortened(gc, text, area.width - 5 * Theme.EDGE);
    Point size = gc.textExtent(words);
    int middle = y + NOTE_HEIGHT / 2;
    HealthDot.paint(gc, theme, health, Theme.EDGE + HealthDot.SIZE / 2, middle);
    gc.setForeground(theme.color(health == Health.BAD ? Role.TEXT : health.role()));
    gc.drawText(words, Theme.EDGE + HealthDot.SIZE + 2 * Theme.STEP, middle - size.y / 2, true);
    return y + NOTE_HEIGHT;
  }

  private static Rectangle centered(Rectangle area, int top, int width) {
    return new Rectangle((area.width - width) / 2, top, width, PILL_HEIGHT);
  }

  private static String shortened(GC gc, String text, int width) {
    if (gc.textExtent(text).x <= width) {
      return text;
    }
    int length = text.length();
    while (length > 1 && gc.textExtent(text.substring(0, length) + "\u2026").x > width) {
      length -= Math.max(1, length / 16);
    }
    return text.substring(0, Math.max(0, length)) + "\u2026";
  }
}
