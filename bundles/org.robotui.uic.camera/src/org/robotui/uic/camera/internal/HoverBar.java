package org.robotui.uic.camera.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;

/** A line of words to press at the upper right, seen while the pointer is over the picture. Display thread. */
final class HoverBar {
  private static final int HEIGHT = 24;
  private static final int CORNER = 8;

  private final Theme theme;
  private final StateView states;
  private List<Cell> cells = List.of();
  private List<Rectangle> places = List.of();

  HoverBar(Theme theme) {
    this.theme = theme;
    this.states = new StateView(theme);
  }

  /**
   * Something to press.
   *
   * @param text a word
   * @param on whether it is in force
   * @param hint what it does, with its key
   * @param run does it
   */
  record Cell(String text, boolean on, String hint, Runnable run) {}

  /** Paints as many cells as there is room for. */
  void paint(GC gc, Rectangle area, int top, List<Cell> wanted, Optional<Point> pointer) {
    gc.setFont(theme.font(Face.SMALL));
    cells = wanted;
    while (!cells.isEmpty() && width(gc) > area.width - 2 * Theme.EDGE) {
      cells = cells.subList(0, cells.size() - 1);
    }
    places = List.of();
    if (!cells.isEmpty()) {
      Rectangle bar = new Rectangle(area.x + area.width - Theme.EDGE - width(gc), top, width(gc), HEIGHT);
      states.pill(gc, bar);
      places = places(gc, bar);
      for (int i = 0; i < cells.size(); i++) {
        paint(gc, cells.get(i), places.get(i), pointer);
      }
    }
  }

  /** It is not seen. */
  void hide() {
    cells = List.of();
    places = List.of();
  }

  /** What lies at a point. */
  Optional<Cell> at(int x, int y) {
    for (int i = 0; i < places.size(); i++) {
      if (places.get(i).contains(x, y)) {
        return Optional.of(cells.get(i));
      }
    }
    return Optional.empty();
  }

  private void paint(GC gc, Cell cell, Rectangle place, Optional<Point> pointer) {
    boolean hot = pointer.filter(place::contains).isPresent();
    if (cell.on() || hot) {
      gc.setBackground(theme.mix(cell.on() ? Role.ACCENT : Role.TEXT, Role.GROUND,
          hot && cell.on() ? 0.3 : cell.on() ? 0.22 : 0.12));
      gc.fillRoundRectangle(place.x + 2, place.y + 2, place.width - 4, place.height - 3, CORNER, CORNER);
    }
    gc.setForeground(theme.color(cell.on() ? Role.ACCENT : hot ? Role.TEXT : Role.DIM));
    Point size = gc.textExtent(cell.text());
    gc.drawText(cell.text(), place.x + (place.width - size.x) / 2, place.y + (place.height - size.y) / 2, true);
  }

  private List<Rectangle> places(GC gc, Rectangle bar) {
    int[] x = {bar.x};
    return cells.stream().map(cell -> {
      Rectangle place = new Rectangle(x[0], bar.y, width(gc, cell), HEIGHT);
      x[0] += place.width;
      return place;
    }).toList();
  }

  private int width(GC gc) {
    return cells.stream().mapToInt(cell -> width(gc, cell)).sum();
  }

  private static int width(GC gc, Cell cell) {
    return gc.textExtent(cell.text()).x + 5 * Theme.STEP;
  }
}
