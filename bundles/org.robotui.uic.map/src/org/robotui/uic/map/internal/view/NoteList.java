package org.robotui.uic.map.internal.view;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.layer.LayerNote;

/** Lines about layers, on a ground of their own: what they lie over may have any colour. Display thread. */
final class NoteList {
  private static final int MOST = 5;
  private static final int HEIGHT = 18;
  private static final int LEAD = HealthDot.SIZE + 2 * Theme.STEP;
  private static final int MIDDLE_HALF = 90;

  private final Theme theme;
  private final StateView states;

  NoteList(Theme theme, StateView states) {
    this.theme = theme;
    this.states = states;
  }

  /**
   * Paints them at the upper left.
   *
   * @param gc where to
   * @param area the map's area
   * @param notes what to say
   * @param below how far down words in the middle of the upper edge go; where the lines are as long as that, they stand
   * below those
   */
  void paint(GC gc, Rectangle area, List<LayerNote> notes, int below) {
    if (notes.isEmpty()) {
      return;
    }
    gc.setFont(theme.font(Face.SMALL));
    List<LayerNote> lines = lines(gc, area.width - 4 * Theme.EDGE - LEAD, notes);
    Rectangle ground = ground(gc, area, lines, below);
    states.pill(gc, ground);
    for (int i = 0; i < lines.size(); i++) {
      line(gc, ground.x + Theme.EDGE, ground.y + Theme.STEP + i * HEIGHT + HEIGHT / 2, lines.get(i));
    }
  }

  private static List<LayerNote> lines(GC gc, int room, List<LayerNote> notes) {
    List<LayerNote> lines = new ArrayList<>();
    notes.stream().limit(MOST).forEach(n -> lines.add(new LayerNote(n.health(), TextFit.shorten(gc, n.text(), room))));
    if (notes.size() > MOST) {
      lines.add(new LayerNote(Health.NONE, "and " + (notes.size() - MOST) + " more"));
    }
    return lines;
  }

  private static Rectangle ground(GC gc, Rectangle area, List<LayerNote> lines, int below) {
    int width = lines.stream().mapToInt(n -> gc.textExtent(n.text()).x).max().orElse(0) + LEAD + 2 * Theme.EDGE;
    boolean reachesMiddle = Theme.EDGE + width + Theme.STEP > area.width / 2 - MIDDLE_HALF;
    return new Rectangle(Theme.EDGE, reachesMiddle ? below : Theme.EDGE, width, lines.size() * HEIGHT + 2 * Theme.STEP);
  }

  private void line(GC gc, int left, int middle, LayerNote note) {
    HealthDot.paint(gc, theme, note.health(), left + HealthDot.SIZE / 2, middle);
    Point size = gc.textExtent(note.text());
    gc.setForeground(theme.color(note.health() == Health.BAD ? Role.TEXT : note.health().role()));
    gc.drawText(note.text(), left + LEAD, middle - size.y / 2, true);
  }
}
